#include "base/exr_header.h"

#include "base/byte_reader.h"

namespace lightbench {
namespace {

constexpr std::size_t kMagicBytes = 4;
constexpr std::uint32_t kMultiPart = 1 << 12;  // a flag of the version
constexpr std::size_t kLongestName = 255;      // that the library reads

struct Size {
  std::int64_t width = 0;
  std::int64_t height = 0;
};

/// A box has its first and its last pixel.
std::optional<Size> read_box(ByteReader& reader) {
  std::int64_t corners[4];  // left, top, right, bottom
  for (std::int64_t& corner : corners) {
    const auto number = reader.little_endian();
    if (!number) return std::nullopt;
    corner = static_cast<std::int32_t>(*number);
  }
  return Size{corners[2] - corners[0] + 1, corners[3] - corners[1] + 1};
}

/// Reads the value of an attribute; whether it ends within the file.
bool read_attribute(ByteReader& reader, const std::string& name, ExrPart& part) {
  const auto type = reader.text(kLongestName);
  if (!type) return false;
  const auto bytes = reader.little_endian();
  if (!bytes || *bytes > reader.size()) return false;
  const bool data = name == "dataWindow", display = name == "displayWindow";
  if ((!data && !display) || *type != "box2i" || *bytes != 16) return reader.skip(*bytes);
  const auto size = read_box(reader);
  if (!size) return false;
  (data ? part.data_width : part.display_width) = size->width;
  (data ? part.data_height : part.display_height) = size->height;
  return true;
}

struct Header {
  std::size_t attributes = 0;
  ExrPart part{};
};

std::optional<Header> read_header(ByteReader& reader) {
  for (Header header;; ++header.attributes) {
    const auto name = reader.text(kLongestName);
    if (!name) return std::nullopt;
    if (name->empty()) return header;
    if (!read_attribute(reader, *name, header.part)) return std::nullopt;
  }
}

}  // namespace

std::optional<std::vector<ExrPart>> read_exr_parts(const std::filesystem::path& file) {
  ByteReader reader(file);
  if (!reader.skip(kMagicBytes)) return std::nullopt;
  const auto version = reader.little_endian();
  if (!version) return std::nullopt;
  const bool several = (*version & kMultiPart) != 0;
  for (std::vector<ExrPart> parts;;) {
    const auto header = read_header(reader);
    if (!header) return std::nullopt;
    // An empty header follows those of the parts.
    if (several && header->attributes == 0) return parts;
    parts.push_back(header->part);
    if (!several) return parts;
  }
}

}  // namespace lightbench
