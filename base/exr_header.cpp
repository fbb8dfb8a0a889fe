#include "base/exr_header.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/input_file.h"

namespace lightbench {
namespace {

constexpr std::size_t kMagicBytes = 4;
constexpr std::uint32_t kMultiPart = 1 << 12;  // a flag of the version

/// Reads the headers from their start; each call tells whether the file goes on so far.
class HeaderReader {
 public:
  explicit HeaderReader(const std::filesystem::path& file) : input_(file, kLargestPictureFile) {}

  bool skip(std::uint64_t count) {
    std::array<char, 4096> block;
    while (count > 0) {
      const std::size_t part = std::size_t(std::min<std::uint64_t>(count, block.size()));
      if (input_.read(std::span(block).first(part)) != part) return false;
      count -= part;
    }
    return true;
  }

  /// A little-endian number.
  std::optional<std::uint32_t> number() {
    std::array<char, 4> bytes{};
    if (input_.read(bytes) != bytes.size()) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
  }

  /// The length of a text that a zero ends.
  std::optional<std::size_t> text() {
    std::array<char, 1> byte{};
    for (std::size_t length = 0;; ++length) {
      if (input_.read(byte) != byte.size()) return std::nullopt;
      if (byte[0] == '\0') return length;
    }
  }

  /// The number of attributes that were passed over up to the end of a header.
  std::optional<std::size_t> header() {
    for (std::size_t count = 0;; ++count) {
      const auto name = text();
      if (!name) return std::nullopt;
      if (*name == 0) return count;
      if (!text()) return std::nullopt;
      const auto size = number();
      if (!size || *size > input_.size() || !skip(*size)) return std::nullopt;
    }
  }

 private:
  InputFile input_;
};

}  // namespace

bool exr_attributes_fit(const std::filesystem::path& file) {
  HeaderReader reader(file);
  if (!reader.skip(kMagicBytes)) return false;
  const auto version = reader.number();
  if (!version) return false;
  if ((*version & kMultiPart) == 0) return reader.header().has_value();
  // An empty header follows those of the parts.
  for (auto count = reader.header();; count = reader.header()) {
    if (!count) return false;
    if (*count == 0) return true;
  }
}

}  // namespace lightbench
