#include "base/image_kinds.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <strings.h>

#include "base/error.h"
#include "base/text.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

using namespace std::string_view_literals;

// Deflate packs 1032 bytes into one; in PNG, a byte may hold 8 pixels. A run of TGA has 128 pixels in 2
// bytes. Formats whose best packing has no simple bound have a generous one.
constexpr std::array kKinds{
    ImageKind{"PNG", "png", 8300},
    ImageKind{"JPEG", "jpeg", 1 << 13},
    ImageKind{"OpenEXR", "openexr", 1 << 16},
    ImageKind{"TGA", "targa", 64},
    ImageKind{"BMP", "bmp", 1 << 13},
    ImageKind{"TIFF", "tiff", 1 << 16},
    ImageKind{"Radiance HDR", "hdr", 1 << 13},
    ImageKind{"WebP", "webp", 1 << 20},
    ImageKind{"PNM", "pnm", 8},
    ImageKind{"PFM", "pnm", 1},
};

/// Bytes that files of a format have at a place near their start. Formats that are not in kKinds are there to
/// be named in errors.
struct Signature {
  std::string_view format;
  std::size_t offset;
  std::string_view bytes;
};

constexpr Signature kSignatures[] = {
    {"PNG", 0, "\x89PNG\r\n\x1a\n"sv},
    {"JPEG", 0, "\xff\xd8\xff"sv},
    {"OpenEXR", 0, "\x76\x2f\x31\x01"sv},
    {"TIFF", 0, "II*\0"sv},
    {"TIFF", 0, "MM\0*"sv},
    {"TIFF", 0, "II+\0"sv},
    {"TIFF", 0, "MM\0+"sv},
    {"Radiance HDR", 0, "#?"sv},
    {"WebP", 8, "WEBP"sv},
    {"BMP", 0, "BM"sv},
    {"PNM", 0, "P1"sv},
    {"PNM", 0, "P2"sv},
    {"PNM", 0, "P3"sv},
    {"PNM", 0, "P4"sv},
    {"PNM", 0, "P5"sv},
    {"PNM", 0, "P6"sv},
    {"PFM", 0, "PF"sv},
    {"PFM", 0, "Pf"sv},

    {"GIF", 0, "GIF8"sv},
    {"IFF", 0, "FORM"sv},
    {"IFF", 0, "FOR4"sv},
    {"DPX", 0, "SDPX"sv},
    {"DPX", 0, "XPDS"sv},
    {"Cineon", 0, "\x80\x2a\x5f\xd7"sv},
    {"Photoshop", 0, "8BPS"sv},
    {"JPEG XL", 0, "\xff\x0a"sv},
    {"JPEG XL", 0, "\0\0\0\x0cJXL "sv},
    {"JPEG 2000", 0, "\0\0\0\x0cjP  "sv},
    {"JPEG 2000", 0, "\xff\x4f\xff\x51"sv},
    {"HEIF or AVIF", 4, "ftyp"sv},
    {"DDS", 0, "DDS "sv},
    {"ICO", 0, "\0\0\1\0"sv},
    {"SGI", 0, "\x01\xda"sv},
    {"Softimage PIC", 0, "\x53\x80\xf6\x34"sv},
    {"FITS", 0, "SIMPLE"sv},
    {"PAM", 0, "P7"sv},
    {"Zfile", 0, "\x2f\x08\x67\xab"sv},
    {"PDF", 0, "%PDF"sv},
    {"SVG", 0, "<svg"sv},
    {"XML", 0, "<?xml"sv},
    {"KTX", 0, "\xabKTX"sv},
    {"gzip", 0, "\x1f\x8b"sv},
    {"ZIP", 0, "PK\3\4"sv},
};

void check_is_file(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status)) throw Error("no such file", file.string());
  if (fs::is_directory(status)) throw Error("is a folder, not an image", file.string());
  if (!fs::is_regular_file(status)) throw Error("is not a regular file", file.string());
}

std::string first_bytes(const fs::path& file) {
  std::string bytes(32, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("cannot read the file", file.string());
  stream.read(bytes.data(), std::streamsize(bytes.size()));
  bytes.resize(std::size_t(stream.gcount()));
  if (bytes.empty()) throw Error("is empty, not an image", file.string());
  return bytes;
}

bool is_named_tga(const fs::path& file) {
  return ::strcasecmp(file.extension().c_str(), ".tga") == 0;
}

/// A TGA header has 18 bytes; these of them have few possible values: colour map, type, size and depth.
bool is_tga_header(std::string_view bytes) {
  if (bytes.size() < 18) return false;
  const auto byte = [&](std::size_t i) { return int(static_cast<unsigned char>(bytes[i])); };
  constexpr std::array kTypes{1, 2, 3, 9, 10, 11};
  constexpr std::array kDepths{8, 15, 16, 24, 32};
  const auto has = [](const auto& values, int value) {
    return std::ranges::find(values, value) != values.end();
  };
  const bool has_size = (byte(12) | byte(13)) != 0 && (byte(14) | byte(15)) != 0;
  return byte(1) <= 1 && has(kTypes, byte(2)) && has_size && has(kDepths, byte(16));
}

std::string_view format_of(std::string_view bytes) {
  for (const Signature& row : kSignatures)
    if (bytes.size() >= row.offset && bytes.substr(row.offset).starts_with(row.bytes)) return row.format;
  return "";
}

const ImageKind* find_kind(std::string_view name) {
  const auto found =
      std::ranges::find(kKinds, name, [](const ImageKind& kind) { return std::string_view(kind.name); });
  return found == kKinds.end() ? nullptr : &*found;
}

}  // namespace

std::string image_kind_names() {
  std::vector<std::string> names;
  for (const ImageKind& kind : kKinds) names.emplace_back(kind.name);
  return join(names, ", ");
}

const ImageKind& image_kind(const fs::path& file) {
  check_is_file(file);
  const std::string bytes = first_bytes(file);
  const std::string_view format = format_of(bytes);
  if (const ImageKind* kind = find_kind(format)) return *kind;
  if (is_named_tga(file) && is_tga_header(bytes)) return *find_kind("TGA");
  if (format.empty())
    throw Error(fmt::format("is in no image format that lightbench reads ({})", image_kind_names()),
                file.string());
  throw Error(fmt::format("seems to be in the format {}; lightbench reads {}", format, image_kind_names()),
              file.string());
}

}  // namespace lightbench
