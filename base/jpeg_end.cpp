#include "base/jpeg_end.h"

#include <cstddef>

namespace lightbench {
namespace {

constexpr unsigned char kEndOfImage = 0xd9;

/// In the pixel data, FF is followed by 0; restart marks and the start of the image stand alone, too.
bool stands_alone(unsigned char marker) {
  return marker <= 0x01 || (marker >= 0xd0 && marker <= 0xd8);
}

}  // namespace

bool reaches_jpeg_end(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  std::size_t at = 0;
  while ((at = bytes.find('\xff', at)) != std::string_view::npos) {
    at = bytes.find_first_not_of('\xff', at);  // any number of them fills
    if (at == std::string_view::npos) return false;
    const unsigned char marker = byte(at++);
    if (marker == kEndOfImage) return true;
    if (stands_alone(marker)) continue;
    if (at + 2 > bytes.size()) return false;
    at += std::size_t(byte(at)) * 256 + byte(at + 1);  // the length counts its own two bytes
  }
  return false;
}

}  // namespace lightbench
