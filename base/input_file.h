#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace lightbench {

/// The largest files that are read, in bytes. A larger one is a mistake or an attack, and is refused before
/// memory is taken for it.
inline constexpr std::uint64_t kLargestTextFile = 64'000'000;        ///< jobs, scenes, cameras, materials
inline constexpr std::uint64_t kLargestModelFile = 4'000'000'000;    ///< OBJ: some 40 million triangles
inline constexpr std::uint64_t kLargestPictureFile = 8'000'000'000;  ///< kMaxImagePixels of 32-bit RGBA
/// What lightbench itself writes and reads again: run.json, plans and ledgers, which grow with the run.
inline constexpr std::uint64_t kLargestOwnFile = 4'000'000'000;

/// A regular file, open for reading from its start to its end. What has no end is refused: opening a FIFO or
/// a device neither waits nor reads.
class InputFile {
 public:
  /// Throws Error with the path where there is no regular file of at most `largest` bytes.
  explicit InputFile(std::filesystem::path file, std::uint64_t largest = kLargestOwnFile);
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  std::uint64_t size() const { return size_; }  ///< when it was opened
  /// Reads until the bytes are full or the file ends, and returns how many it read. Throws Error where
  /// reading fails.
  std::size_t read(std::span<char> bytes);

 private:
  std::filesystem::path file_;
  int descriptor_;
  std::uint64_t size_ = 0;
};

/// "64 MB": rounded, for messages.
std::string bytes_text(std::uint64_t bytes);

}  // namespace lightbench
