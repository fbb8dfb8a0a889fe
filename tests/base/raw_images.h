#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

/// Files that OpenImageIO does not write, byte by byte.
namespace lightbench::test {

inline std::string little_endian(std::uint32_t value, int bytes = 4) {
  std::string result;
  for (int i = 0; i < bytes; ++i) result += char(value >> 8 * i);
  return result;
}

inline std::string big_endian(std::uint32_t value, int bytes = 4) {
  const std::string little = little_endian(value, bytes);
  return {little.rbegin(), little.rend()};
}

/// As PNG has it (ISO 3309).
inline std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t sum = 0xffffffff;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum;
}

/// As zlib has it (RFC 1950).
inline std::uint32_t adler(std::string_view bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char byte : bytes) {
    a = (a + static_cast<unsigned char>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

inline std::string png_chunk(const std::string& type, const std::string& data) {
  return big_endian(std::uint32_t(data.size())) + type + data + big_endian(checksum(type + data));
}

enum class PngColor { grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgb_alpha = 6 };

/// `rows` has a byte 0, for no filter, before each row; `chunks` stand before the pixels.
inline std::string raw_png(int width, int height, PngColor color, int bits, const std::string& rows,
                           const std::string& chunks = "") {
  const std::string header = big_endian(std::uint32_t(width)) + big_endian(std::uint32_t(height)) +
                             char(bits) + char(color) + std::string(3, '\0');
  const auto length = std::uint32_t(rows.size());
  const std::string packed = "\x78\x01\x01" + little_endian(length, 2) + little_endian(~length, 2) + rows +
                             big_endian(adler(rows));  // one block that is stored as it is
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + chunks + png_chunk("IDAT", packed) +
         png_chunk("IEND", "");
}

/// An Exif block with nothing but an orientation.
inline std::string exif_block(int orientation) {
  using namespace std::string_literals;
  return "MM\0*"s + big_endian(8) + big_endian(1, 2) + big_endian(274, 2) + big_endian(3, 2) + big_endian(1) +
         big_endian(std::uint32_t(orientation), 2) + "\0\0"s + big_endian(0);
}

/// A TGA of 32 bits with the origin above; the attribute bits say how many of them are alpha.
inline std::string raw_tga(int width, int height, int attribute_bits, const std::string& bgra) {
  return std::string("\0\0\2", 3) + std::string(9, '\0') + little_endian(std::uint32_t(width), 2) +
         little_endian(std::uint32_t(height), 2) + char(32) + char(0x20 | attribute_bits) + bgra;
}

/// A BMP of 32 bits, its last row first. Without masks it has a header of 40 bytes, with four of 108.
inline std::string raw_bmp(int width, int height, std::initializer_list<std::uint32_t> masks,
                           const std::string& pixels) {
  std::string header = little_endian(masks.size() == 0 ? 40 : 108) + little_endian(std::uint32_t(width)) +
                       little_endian(std::uint32_t(height)) + little_endian(1, 2) + little_endian(32, 2) +
                       little_endian(masks.size() == 0 ? 0 : 3) +
                       little_endian(std::uint32_t(pixels.size())) + std::string(16, '\0');
  for (const std::uint32_t mask : masks) header += little_endian(mask);
  header.resize(masks.size() == 0 ? 40 : 108);
  const auto start = std::uint32_t(14 + header.size());
  return "BM" + little_endian(start + std::uint32_t(pixels.size())) + little_endian(0) +
         little_endian(start) + header + pixels;
}

}  // namespace lightbench::test
