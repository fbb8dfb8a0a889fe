#include "base/image_io.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "base/color.h"
#include "base/error.h"
#include "base/openimageio.h"
#include "base/picture_file.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

/// How colour and alpha stand to each other in what a reader returns.
enum class Alpha { premultiplied, straight };

/// From a grey in the first component, and its alpha behind it, to the components of colour and alpha.
template <typename Component>
void spread_grey(BasicImage<Component>& image, bool has_alpha) {
  for (std::size_t i = 0; i < image.data.size(); i += std::size_t(image.channels)) {
    Component* pixel = &image.data[i];
    if (has_alpha) pixel[3] = pixel[1];
    pixel[1] = pixel[2] = pixel[0];
  }
}

/// RGB, or RGBA if the file has an alpha or one is wanted, which then is `opaque` where the file has none.
template <typename Component>
BasicImage<Component> read_colors(PictureFile& file, Component opaque, bool want_alpha = false) {
  const bool has_alpha = file.has_alpha();
  auto image = file.read<Component>(want_alpha || has_alpha ? 4 : 3, opaque);
  if (file.channels() < 3) spread_grey(image, has_alpha);
  return image;
}

/// One component of linear light, from what the file has for it.
float to_light(const PictureFile& file, float stored, float alpha, Alpha wanted) {
  const bool divides = file.is_premultiplied() && alpha > 0;
  const float light = decode(file.transfer(), divides ? stored / alpha : stored);
  // Colour where a premultiplied file has no alpha is light that something sends out and nothing covers.
  const bool multiplies = wanted == Alpha::premultiplied && (divides || !file.is_premultiplied());
  return multiplies ? light * alpha : light;
}

void to_light(const PictureFile& file, Image& image, Alpha wanted) {
  const bool linear = file.transfer().kind == Transfer::Kind::linear;
  const bool as_wanted = !file.has_alpha() || (file.is_premultiplied() && wanted == Alpha::premultiplied);
  if (linear && as_wanted) return;  // with every bit
  const auto channels = std::size_t(image.channels);
  for (std::size_t i = 0; i < image.data.size(); i += channels) {
    const float alpha = file.has_alpha() ? image.data[i + 3] : 1.0f;
    for (std::size_t c = 0; c < 3; ++c) image.data[i + c] = to_light(file, image.data[i + c], alpha, wanted);
  }
}

Image read_light(PictureFile& file, Alpha wanted, bool want_alpha = false) {
  Image image = read_colors<float>(file, 1.0f, want_alpha);
  to_light(file, image, wanted);
  return image;
}

Image8 rounded(const Image& image, const fs::path& file) {
  if (const auto bad = first_non_finite(image); bad >= 0) {
    const auto pixel = std::size_t(bad) / std::size_t(image.channels);
    throw Error(fmt::format("pixel ({}, {}) is not a finite number", pixel % std::size_t(image.width),
                            pixel / std::size_t(image.width)),
                file.string());
  }
  return to_srgb8(image);
}

/// Whether the 8 bits that the file has, or that OpenImageIO rounds to, lose nothing.
bool is_read_as_8_bits(const PictureFile& file) {
  return file.spec().format == OIIO::TypeDesc::UINT8 ||
         (file.transfer().kind == Transfer::Kind::srgb && !file.has_alpha());
}

std::uint8_t to_8_bits(float light) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(srgb_encode(light), 0.0f, 1.0f) * 255.0f));
}

/// From components as stored to sRGB. Those of opaque pixels of sRGB stay as they are.
void to_srgb(const PictureFile& file, Image8& image, Alpha wanted) {
  std::array<std::uint8_t, 256> opaque{};
  for (std::size_t i = 0; i < opaque.size(); ++i)
    opaque[i] = to_8_bits(decode(file.transfer(), float(i) / 255.0f));
  const bool kept = file.transfer().kind == Transfer::Kind::srgb;
  const bool straight = !file.has_alpha() || (!file.is_premultiplied() && wanted == Alpha::straight);
  if (kept && straight) return;
  const auto channels = std::size_t(image.channels);
  for (std::size_t i = 0; i < image.data.size(); i += channels) {
    const std::uint8_t alpha = straight ? 255 : image.data[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint8_t& value = image.data[i + c];
      if (alpha != 255)
        value = to_8_bits(to_light(file, float(value) / 255.0f, float(alpha) / 255.0f, wanted));
      else if (!kept)
        value = opaque[value];
    }
  }
}

Image8 read_srgb(PictureFile& file, const fs::path& path, Alpha wanted, bool want_alpha = false) {
  if (!is_read_as_8_bits(file)) return rounded(read_light(file, wanted, want_alpha), path);
  Image8 image = read_colors<std::uint8_t>(file, 255, want_alpha);
  to_srgb(file, image, wanted);
  return image;
}

}  // namespace

Image read_image(const fs::path& file, const std::string& layer) {
  return guarded(file.string(), [&] {
    PictureFile picture(file, layer, PictureFile::Channels::picture);
    return read_light(picture, Alpha::premultiplied);
  });
}

Image8 read_image_srgb8(const fs::path& file, const std::string& layer) {
  return guarded(file.string(), [&] {
    PictureFile picture(file, layer, PictureFile::Channels::picture);
    return read_srgb(picture, file, Alpha::premultiplied);
  });
}

Image8 read_image_rgba8(const fs::path& file, int max_side) {
  return guarded(file.string(), [&] {
    PictureFile picture(file, "", PictureFile::Channels::picture);
    if (std::max(picture.width(), picture.height()) > max_side)
      throw Error(
          fmt::format("{} x {} pixels are more than {} a side", picture.width(), picture.height(), max_side),
          file.string());
    return read_srgb(picture, file, Alpha::straight, true);
  });
}

Image read_float_image(const fs::path& file) {
  return guarded(file.string(), [&] {
    PictureFile buffer(file, "", PictureFile::Channels::first_four);
    return buffer.read<float>(buffer.channels());
  });
}

ImageMetadata read_image_metadata(const fs::path& file) {
  return guarded(file.string(), [&] {
    const PictureFile picture(file, "", PictureFile::Channels::first_four);
    ImageMetadata metadata;
    for (const auto& attribute : picture.spec().extra_attribs)
      if (attribute.type() == OIIO::TypeDesc::STRING)
        metadata[attribute.name().string()] = attribute.get_string();
    return metadata;
  });
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
