#include "base/orientation.h"

#include <cstdint>

#include "base/byte_reader.h"

namespace lightbench {
namespace {

constexpr std::uint32_t kOrientationTag = 274;
constexpr std::size_t kEntryBytes = 12;
constexpr std::size_t kLongestExif = 1 << 20;

/// The numbers of a TIFF file; 0 beyond its end.
struct TiffBytes {
  std::string_view bytes;
  bool little_endian;

  std::uint32_t number(std::size_t place, std::size_t count) const {
    std::uint32_t value = 0;
    if (place > bytes.size() || bytes.size() - place < count) return value;
    for (std::size_t i = 0; i < count; ++i)
      value = value << 8 | static_cast<unsigned char>(bytes[place + (little_endian ? count - 1 - i : i)]);
    return value;
  }
};

}  // namespace

Orientation exif_orientation(std::string_view exif) {
  constexpr std::string_view kPrefix("Exif\0\0", 6);  // as JPEG has it; some write it into WebP, too
  if (exif.starts_with(kPrefix)) exif.remove_prefix(kPrefix.size());
  if (!exif.starts_with("II") && !exif.starts_with("MM")) return 1;
  const TiffBytes tiff{exif, exif.starts_with("II")};
  const std::size_t directory = tiff.number(4, 4);
  const std::size_t entries = tiff.number(directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + i * kEntryBytes;
    if (tiff.number(entry, 2) != kOrientationTag) continue;
    const auto value = Orientation(tiff.number(entry + 8, 2));
    return value >= 1 && value <= 8 ? value : 1;
  }
  return 1;
}

Orientation read_webp_orientation(const std::filesystem::path& file) {
  ByteReader reader(file);
  reader.skip(12);  // RIFF, a size, WEBP
  for (;;) {
    const std::string name = reader.bytes(4);
    const auto bytes = reader.little_endian();
    if (!bytes) return 1;
    if (name == "EXIF") return exif_orientation(reader.bytes(std::min<std::size_t>(*bytes, kLongestExif)));
    if (!reader.skip(*bytes + std::uint64_t(*bytes % 2))) return 1;
  }
}

}  // namespace lightbench
