#include "base/byte_reader.h"

#include <algorithm>

namespace lightbench {
namespace {

std::uint32_t number_of(const std::string& bytes, bool little_endian) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[little_endian ? bytes.size() - 1 - i : i]);
  return value;
}

}  // namespace

/// Whether there is a byte to take.
bool ByteReader::fill() {
  if (begin_ < end_) return true;
  begin_ = 0;
  end_ = input_.read(block_);
  return end_ > 0;
}

bool ByteReader::skip(std::uint64_t count) {
  while (count > 0 && fill()) {
    const std::size_t part = std::size_t(std::min<std::uint64_t>(count, end_ - begin_));
    begin_ += part;
    count -= part;
  }
  return count == 0;
}

std::string ByteReader::bytes(std::size_t count) {
  std::string result;
  while (result.size() < count && fill()) {
    const std::size_t part = std::min(count - result.size(), end_ - begin_);
    result.append(&block_[begin_], part);
    begin_ += part;
  }
  return result;
}

std::optional<std::uint32_t> ByteReader::little_endian() {
  const std::string four = bytes(4);
  return four.size() == 4 ? std::optional(number_of(four, true)) : std::nullopt;
}

std::optional<std::uint32_t> ByteReader::big_endian() {
  const std::string four = bytes(4);
  return four.size() == 4 ? std::optional(number_of(four, false)) : std::nullopt;
}

std::optional<std::string> ByteReader::text(std::size_t longest) {
  for (std::string result; fill(); result += block_[begin_++]) {
    if (block_[begin_] == '\0') {
      ++begin_;
      return result;
    }
    if (result.size() == longest) break;
  }
  return std::nullopt;
}

}  // namespace lightbench
