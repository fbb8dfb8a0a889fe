#include <algorithm>
#include <cmath>
#include <span>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image_io.h"
#include "base/openimageio.h"
#include "base/text.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

// From here on a number is rounded to an infinite half.
constexpr float kRoundedToInfiniteHalf = 65520;

bool exceeds_half(float value) {
  return std::isfinite(value) && std::abs(value) >= kRoundedToInfiniteHalf;
}

/// Returns the number of pixels that have been changed.
std::size_t clamp_to_half(Image& image) {
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < image.data.size(); i += std::size_t(image.channels)) {
    const auto pixel = std::span(image.data).subspan(i, std::size_t(image.channels));
    if (std::ranges::none_of(pixel, exceeds_half)) continue;
    ++pixels;
    for (float& value : pixel)
      if (exceeds_half(value)) value = std::copysign(kLargestHalf, value);
  }
  return pixels;
}

OIIO::ImageSpec output_spec(int width, int height, int channels, const OIIO::TypeDesc& type) {
  OIIO::ImageSpec spec(width, height, channels, type);
  if (channels == 4) spec.alpha_channel = 3;
  return spec;
}

/// Instead of the time of writing, so that equal images are equal files.
constexpr const char* kNoDate = "1970:01:01 00:00:00";

using Bytes = std::vector<unsigned char>;

std::string_view view_of(const Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The image as a file of the format in memory: OpenImageIO's own writing of files overlooks full disks.
Bytes encode(const char* format, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type, const void* pixels,
             const std::string& where) {
  check_image_size(spec.width, spec.height, where);
  configure_openimageio();
  return guarded(where, [&] {
    Bytes bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    auto output = OIIO::ImageOutput::create(format, &memory);
    if (!output || !output->open(std::string("memory.") + format, spec) ||
        !output->write_image(type, pixels) || !output->close())
      throw Error("cannot encode the image: " + one_line(output ? output->geterror() : OIIO::geterror()),
                  where);
    return bytes;
  });
}

Bytes encode_png_bytes(const Image8& image, const std::string& where) {
  auto spec = output_spec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("png:compressionLevel", 4);
  return encode("png", spec, OIIO::TypeDesc::UINT8, image.data.data(), where);
}

}  // namespace

std::size_t write_exr(const fs::path& file, const Image& image, PixelType type,
                      const ImageMetadata& metadata) {
  const bool half = type == PixelType::half;
  if (half && std::ranges::any_of(image.data, exceeds_half)) {
    Image clamped = image;
    const std::size_t pixels = clamp_to_half(clamped);
    write_exr(file, clamped, type, metadata);
    return pixels;
  }
  auto spec = output_spec(image.width, image.height, image.channels,
                          half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", kNoDate);
  for (const auto& [name, value] : metadata) spec.attribute(name, value);
  write_file_atomic(
      file, view_of(encode("openexr", spec, OIIO::TypeDesc::FLOAT, image.data.data(), file.string())));
  return 0;
}

void write_png(const fs::path& file, const Image8& image) {
  write_file_atomic(file, view_of(encode_png_bytes(image, file.string())));
}

std::string encode_png(const Image8& image) {
  return std::string(view_of(encode_png_bytes(image, "")));
}

}  // namespace lightbench
