#include "base/png_header.h"

#include <array>
#include <cstdlib>

#include "base/byte_reader.h"
#include "base/error.h"

namespace lightbench {
namespace {

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kChecksumBytes = 4;

// White, red, green and blue as x and y, and the gamma, in units of 1/100000.
constexpr std::array<long, 8> kSrgbPrimaries{31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000};
constexpr long kSrgbGamma = 45455;

/// Writers round these numbers in several ways.
bool is_near(long value, long wanted) {
  return std::labs(value - wanted) <= 100;
}

struct ColorChunks {
  bool space = false;           // sRGB or iCCP
  bool srgb_primaries = false;  // in cHRM
  long gamma = 0;
};

bool read_primaries(ByteReader& reader) {
  bool same = true;
  for (const long wanted : kSrgbPrimaries)
    same = is_near(long(reader.big_endian().value_or(0)), wanted) && same;
  return same;
}

/// Reads what counts of a chunk, and returns how many of its bytes it has read.
std::size_t read_chunk(ByteReader& reader, const std::string& type, std::uint32_t bytes,
                       ColorChunks& chunks) {
  if (type == "sRGB" || type == "iCCP" || type == "cICP") chunks.space = true;
  if (type == "gAMA" && bytes == 4) {
    chunks.gamma = long(reader.big_endian().value_or(0));
    return bytes;
  }
  if (type == "cHRM" && bytes == 4 * kSrgbPrimaries.size()) {
    chunks.srgb_primaries = read_primaries(reader);
    return bytes;
  }
  return 0;
}

}  // namespace

std::optional<float> read_png_exponent(const std::filesystem::path& file) {
  ByteReader reader(file);
  bool whole = reader.skip(kSignatureBytes);
  ColorChunks chunks;
  for (std::string type; whole && type != "IEND";) {
    const auto bytes = reader.big_endian();
    type = reader.bytes(4);
    if (!bytes || type.size() < 4)
      throw Error("truncated PNG image: it does not reach its end", file.string());
    const std::size_t done = read_chunk(reader, type, *bytes, chunks);
    whole = reader.skip(*bytes - done + std::uint64_t(kChecksumBytes));
  }
  if (!whole) throw Error("truncated PNG image: it does not reach its end", file.string());
  if (chunks.space || chunks.gamma <= 0) return std::nullopt;
  if (chunks.srgb_primaries && is_near(chunks.gamma, kSrgbGamma)) return std::nullopt;
  return 100000.0f / float(chunks.gamma);
}

}  // namespace lightbench
