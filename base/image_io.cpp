#include "base/image_io.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <span>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "base/color.h"
#include "base/error.h"
#include "base/exr_header.h"
#include "base/files.h"
#include "base/image_kinds.h"
#include "base/input_file.h"
#include "base/jpeg_end.h"
#include "base/text.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

constexpr int kMaxImageMegabytes = 4096;  // what kMaxImagePixels pixels of four floats take

void configure_oiio() {
  // One decoder thread: as many processes run as there are cores. The limit holds before a reader allocates.
  static const bool configured = OIIO::attribute("threads", 1) && OIIO::attribute("exr_threads", -1) &&
                                 OIIO::attribute("limits:imagesize_MB", kMaxImageMegabytes);
  static_cast<void>(configured);
}

/// Calls `action`; whatever the library throws becomes an Error with the file.
template <typename Action>
auto guarded(const std::string& file, const Action& action) {
  try {
    return action();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error("the image does not fit in memory", file);
  } catch (const std::exception& error) {
    throw Error("OpenImageIO fails: " + one_line(error.what()), file);
  }
}

/// So that a few bytes cannot ask for gigabytes.
void check_plausible_size(const OIIO::ImageSpec& spec, const ImageKind& kind, const fs::path& file) {
  check_image_size(spec.width, spec.height, file.string());
  if (fs::file_size(file) > kLargestPictureFile)
    throw Error("is larger than any picture that is read: " + bytes_text(fs::file_size(file)), file.string());
  const std::uint64_t pixels = std::uint64_t(spec.width) * std::uint64_t(spec.height);
  if (const std::uint64_t bytes = fs::file_size(file); pixels / kind.most_pixels_per_byte > bytes)
    throw Error(
        fmt::format("damaged image: {} bytes cannot hold {} x {} pixels", bytes, spec.width, spec.height),
        file.string());
}

void check_flat(const OIIO::ImageSpec& spec, const fs::path& file) {
  if (spec.deep)
    throw Error("is a deep image, with several depths in a pixel; only flat ones are read", file.string());
  if (spec.depth > 1) throw Error("is a volume of several layers; only flat images are read", file.string());
  if (spec.nchannels < 1) throw Error("is an image without components", file.string());
}

/// Only the reader of the file's kind is tried.
std::unique_ptr<OIIO::ImageInput> open_input(const fs::path& file) {
  configure_oiio();
  const ImageKind& kind = image_kind(file);
  if (std::string_view(kind.reader) == "openexr" && !exr_attributes_fit(file))
    throw Error("damaged OpenEXR image: its header does not end within the file", file.string());
  auto input = OIIO::ImageInput::create(kind.reader);
  if (!input) throw Error(fmt::format("OpenImageIO cannot read {} here", kind.name), file.string());
  OIIO::ImageSpec config, spec;
  config.attribute("oiio:UnassociatedAlpha", 1);
  if (!input->open(file.string(), spec, config))
    throw Error(fmt::format("damaged {} image: {}", kind.name, one_line(input->geterror())), file.string());
  check_flat(spec, file);
  check_plausible_size(spec, kind, file);
  if (std::string_view(kind.reader) == "jpeg" && !reaches_jpeg_end(read_file(file)))
    throw Error("truncated JPEG image: it does not reach its end", file.string());
  return input;
}

bool stores_integers(const OIIO::ImageSpec& spec) {
  return !spec.format.is_floating_point();
}

/// The file's first components, up to those of `image`, in the first components of its pixels.
template <typename Component>
void read_into(BasicImage<Component>& image, OIIO::ImageInput& input, const fs::path& file,
               const OIIO::TypeDesc& type) {
  const int channels = std::min(input.spec().nchannels, image.channels);
  const auto stride = OIIO::stride_t(std::size_t(image.channels) * sizeof(Component));
  const bool read = input.read_image(0, 0, 0, channels, type, image.data.data(), stride);
  if (!read || input.has_error())  // of TIFF, it says that it read what is not there
    throw Error("truncated or damaged image: " + one_line(input.geterror()), file.string());
}

template <typename Component>
BasicImage<Component> read_components(OIIO::ImageInput& input, const fs::path& file,
                                      const OIIO::TypeDesc& type) {
  const OIIO::ImageSpec& spec = input.spec();
  BasicImage<Component> image(spec.width, spec.height, std::min(spec.nchannels, 4));
  read_into(image, input, file, type);
  return image;
}

/// Grey to RGB, grey with alpha to RGBA.
template <typename Component>
BasicImage<Component> with_color(BasicImage<Component> image) {
  if (image.channels >= 3) return image;
  BasicImage<Component> result(image.width, image.height, image.channels + 2);
  for (std::size_t i = 0; i < image.pixel_count(); ++i) {
    const Component* source = &image.data[i * std::size_t(image.channels)];
    Component* target = &result.data[i * std::size_t(result.channels)];
    target[0] = target[1] = target[2] = source[0];
    if (image.channels == 2) target[3] = source[1];
  }
  return result;
}

/// A float file as 8 bits.
Image8 rounded_floats(OIIO::ImageInput& input, const fs::path& file) {
  const Image image = with_color(read_components<float>(input, file, OIIO::TypeDesc::FLOAT));
  if (const auto bad = first_non_finite(image); bad >= 0) {
    const auto pixel = std::size_t(bad) / std::size_t(image.channels);
    throw Error(fmt::format("pixel ({}, {}) is not a finite number", pixel % std::size_t(image.width),
                            pixel / std::size_t(image.width)),
                file.string());
  }
  return to_srgb8(image);
}

/// Pixels of RGBA that hold the components of a file with fewer of them in their first places.
void spread_grey(Image8& image, int channels) {
  if (channels >= 3) return;
  for (std::size_t i = 0; i < image.data.size(); i += 4) {
    std::uint8_t* pixel = &image.data[i];
    if (channels == 2) pixel[3] = pixel[1];
    pixel[1] = pixel[2] = pixel[0];
  }
}

Image8 with_alpha(Image8 image) {
  if (image.channels == 4) return image;
  Image8 result(image.width, image.height, 4, 255);
  for (std::size_t i = 0; i < image.pixel_count(); ++i)
    std::copy_n(&image.data[i * 3], 3, &result.data[i * 4]);
  return result;
}

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
  configure_oiio();
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

Image read_image(const fs::path& file) {
  return guarded(file.string(), [&] {
    auto input = open_input(file);
    const bool encoded = stores_integers(input->spec());
    Image image = with_color(read_components<float>(*input, file, OIIO::TypeDesc::FLOAT));
    if (!encoded) return image;
    for (std::size_t i = 0; i < image.data.size(); ++i)
      if (image.channels != 4 || i % 4 != 3) image.data[i] = srgb_decode(image.data[i]);
    return image;
  });
}

Image8 read_image_srgb8(const fs::path& file) {
  return guarded(file.string(), [&] {
    auto input = open_input(file);
    if (!stores_integers(input->spec())) return rounded_floats(*input, file);
    return with_color(read_components<std::uint8_t>(*input, file, OIIO::TypeDesc::UINT8));
  });
}

Image8 read_image_rgba8(const fs::path& file, int max_side) {
  return guarded(file.string(), [&] {
    auto input = open_input(file);
    const OIIO::ImageSpec& spec = input->spec();
    if (std::max(spec.width, spec.height) > max_side)
      throw Error(fmt::format("{} x {} pixels are more than {} a side", spec.width, spec.height, max_side),
                  file.string());
    if (!stores_integers(spec)) return with_alpha(rounded_floats(*input, file));
    Image8 image(spec.width, spec.height, 4, 255);
    read_into(image, *input, file, OIIO::TypeDesc::UINT8);
    spread_grey(image, spec.nchannels);
    return image;
  });
}

Image read_float_image(const fs::path& file) {
  return guarded(file.string(), [&] {
    auto input = open_input(file);
    return read_components<float>(*input, file, OIIO::TypeDesc::FLOAT);
  });
}

ImageMetadata read_image_metadata(const fs::path& file) {
  return guarded(file.string(), [&] {
    auto input = open_input(file);
    ImageMetadata metadata;
    for (const auto& attribute : input->spec().extra_attribs)
      if (attribute.type() == OIIO::TypeDesc::STRING)
        metadata[attribute.name().string()] = attribute.get_string();
    return metadata;
  });
}

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

void check_image_size(long long width, long long height, const std::string& where) {
  if (width < 1 || height < 1)
    throw Error(fmt::format("an image of {} x {} pixels has nothing in it", width, height), where);
  if (width > kMaxImageSide || height > kMaxImageSide ||
      std::size_t(width) * std::size_t(height) > kMaxImagePixels)
    throw Error(fmt::format("an image of {} x {} pixels is too large (at most {} a side and {} in all)",
                            width, height, kMaxImageSide, kMaxImagePixels),
                where);
}

}  // namespace lightbench
