#include "base/image_io.h"

#include <memory>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "base/color.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"

namespace lightbench {
namespace {

std::unique_ptr<OIIO::ImageInput> open_input(const std::filesystem::path& file) {
  // One decoder thread: as many processes run as there are cores.
  static const bool configured = OIIO::attribute("threads", 1) && OIIO::attribute("exr_threads", -1);
  static_cast<void>(configured);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) throw Error("no such file", file.string());
  if (std::filesystem::is_directory(file, ignored)) throw Error("is a folder, not an image", file.string());
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(file.string(), &config);
  if (!input) throw Error("not a readable image: " + one_line(OIIO::geterror()), file.string());
  check_image_size(input->spec().width, input->spec().height, file.string());
  return input;
}

bool stores_integers(const OIIO::ImageSpec& spec) {
  return !spec.format.is_floating_point();
}

template <typename Component>
BasicImage<Component> read_components(OIIO::ImageInput& input, const std::filesystem::path& file,
                                      const OIIO::TypeDesc& type) {
  const OIIO::ImageSpec& spec = input.spec();
  const int channels = std::min(spec.nchannels, 4);
  BasicImage<Component> image(spec.width, spec.height, channels);
  if (!input.read_image(0, 0, 0, channels, type, image.data.data()))
    throw Error("truncated or damaged image: " + one_line(input.geterror()), file.string());
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

OIIO::ImageSpec output_spec(int width, int height, int channels, const OIIO::TypeDesc& type) {
  OIIO::ImageSpec spec(width, height, channels, type);
  if (channels == 4) spec.alpha_channel = 3;
  return spec;
}

void write_with_oiio(const std::filesystem::path& file, const OIIO::ImageSpec& spec,
                     const OIIO::TypeDesc& type, const void* pixels) {
  check_image_size(spec.width, spec.height, file.string());
  AtomicFile target(file);
  auto output = OIIO::ImageOutput::create(file.string());
  if (!output) throw Error("cannot write this kind of image: " + one_line(OIIO::geterror()), file.string());
  if (!output->open(target.path().string(), spec) || !output->write_image(type, pixels) || !output->close())
    throw Error("cannot write: " + one_line(output->geterror()), file.string());
  target.commit();
}

OIIO::ImageSpec png_spec(const Image8& image) {
  auto spec = output_spec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("png:compressionLevel", 4);
  return spec;
}

}  // namespace

Image read_image(const std::filesystem::path& file) {
  auto input = open_input(file);
  const bool encoded = stores_integers(input->spec());
  Image image = with_color(read_components<float>(*input, file, OIIO::TypeDesc::FLOAT));
  if (!encoded) return image;
  for (std::size_t i = 0; i < image.data.size(); ++i)
    if (image.channels != 4 || i % 4 != 3) image.data[i] = srgb_decode(image.data[i]);
  return image;
}

Image8 read_image_srgb8(const std::filesystem::path& file) {
  auto input = open_input(file);
  if (stores_integers(input->spec()))
    return with_color(read_components<std::uint8_t>(*input, file, OIIO::TypeDesc::UINT8));
  const Image image = with_color(read_components<float>(*input, file, OIIO::TypeDesc::FLOAT));
  if (const auto bad = first_non_finite(image); bad >= 0) {
    const auto pixel = std::size_t(bad) / std::size_t(image.channels);
    throw Error(fmt::format("pixel ({}, {}) is not a finite number", pixel % std::size_t(image.width),
                            pixel / std::size_t(image.width)),
                file.string());
  }
  return to_srgb8(image);
}

Image read_float_image(const std::filesystem::path& file) {
  auto input = open_input(file);
  return read_components<float>(*input, file, OIIO::TypeDesc::FLOAT);
}

ImageMetadata read_image_metadata(const std::filesystem::path& file) {
  auto input = open_input(file);
  ImageMetadata metadata;
  for (const auto& attribute : input->spec().extra_attribs)
    if (attribute.type() == OIIO::TypeDesc::STRING)
      metadata[attribute.name().string()] = attribute.get_string();
  return metadata;
}

void write_exr(const std::filesystem::path& file, const Image& image, PixelType type,
               const ImageMetadata& metadata) {
  auto spec = output_spec(image.width, image.height, image.channels,
                          type == PixelType::half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  for (const auto& [name, value] : metadata) spec.attribute(name, value);
  write_with_oiio(file, spec, OIIO::TypeDesc::FLOAT, image.data.data());
}

void write_png(const std::filesystem::path& file, const Image8& image) {
  write_with_oiio(file, png_spec(image), OIIO::TypeDesc::UINT8, image.data.data());
}

std::string encode_png(const Image8& image) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  auto output = OIIO::ImageOutput::create("png", &memory);
  if (!output || !output->open("memory.png", png_spec(image)) ||
      !output->write_image(OIIO::TypeDesc::UINT8, image.data.data()) || !output->close())
    throw Error("cannot encode a PNG: " + one_line(output ? output->geterror() : OIIO::geterror()));
  return {bytes.begin(), bytes.end()};
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
