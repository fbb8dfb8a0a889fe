#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/input_file.h"

namespace lightbench {

/// Reads the numbers and texts of a picture's header, from the file's start on. What the file is too short
/// for is no value. Throws Error where the file cannot be read.
class ByteReader {
 public:
  explicit ByteReader(const std::filesystem::path& file) : input_(file, kLargestPictureFile) {}

  std::uint64_t size() const { return input_.size(); }
  /// Whether the file has as many bytes more.
  bool skip(std::uint64_t count);
  /// So many bytes, or those up to the end of the file.
  std::string bytes(std::size_t count);
  std::optional<std::uint32_t> little_endian();
  std::optional<std::uint32_t> big_endian();
  /// A text that a zero ends, without it; none where there are more than `longest` bytes before the zero.
  std::optional<std::string> text(std::size_t longest);

 private:
  bool fill();

  InputFile input_;
  std::array<char, 4096> block_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

}  // namespace lightbench
