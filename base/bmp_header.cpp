#include "base/bmp_header.h"

#include "base/byte_reader.h"
#include "base/error.h"

namespace lightbench {
namespace {

// These are offsets in the header that follows the 14 bytes of the file header.
constexpr std::size_t kFileHeaderBytes = 14;
constexpr std::size_t kBitsPlace = 14;
constexpr std::size_t kCompressionPlace = 16;
constexpr std::size_t kMasksPlace = 40;
constexpr std::uint32_t kHeaderWithAlphaMask = 56;  // the size of the smallest one

enum Compression : std::uint32_t { bit_fields = 3, alpha_bit_fields = 6 };

/// A little-endian number; 0 where the header is too short.
std::uint32_t number_at(const std::string& header, std::size_t place, std::size_t bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes; i-- > 0;)
    value = value << 8 | (place + i < header.size() ? static_cast<unsigned char>(header[place + i]) : 0u);
  return value;
}

}  // namespace

bool read_bmp_has_alpha(const std::filesystem::path& file) {
  ByteReader reader(file);
  reader.skip(kFileHeaderBytes);
  const std::string header = reader.bytes(kHeaderWithAlphaMask);
  const std::uint32_t compression = number_at(header, kCompressionPlace, 4);
  const bool masks = compression == bit_fields || compression == alpha_bit_fields;
  if (!masks || number_at(header, kBitsPlace, 2) != 32) return false;
  const auto mask = [&](std::size_t i) { return number_at(header, kMasksPlace + 4 * i, 4); };
  const bool alpha_mask = number_at(header, 0, 4) >= kHeaderWithAlphaMask || compression == alpha_bit_fields;
  const std::uint32_t alpha = alpha_mask ? mask(3) : 0;
  if (mask(0) != 0xff0000 || mask(1) != 0xff00 || mask(2) != 0xff || (alpha != 0 && alpha != 0xff000000))
    throw Error("is a BMP image with colours in an order that is not read; only blue, green, red, alpha is",
                file.string());
  return alpha != 0;
}

}  // namespace lightbench
