#pragma once

#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "base/image.h"

namespace lightbench::test {

/// Noise, which no format packs well.
inline Image8 picture(int width = 23, int height = 17, int channels = 3) {
  Image8 image(width, height, channels);
  std::mt19937 random(1);
  for (std::uint8_t& component : image.data) component = std::uint8_t(random());
  return image;
}

/// The image as a file of a format, by OpenImageIO's name of it. The orientation is noted, and the pixels are
/// stored as they are.
inline std::string encoded(const std::string& format, const Image8& image,
                           const std::string& compression = "", int orientation = 1) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  auto output = OIIO::ImageOutput::create(format, &memory);
  OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  if (!compression.empty()) spec.attribute("compression", compression);
  if (orientation != 1) spec.attribute("Orientation", orientation);
  if (!output || !output->open("memory." + format, spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, image.data.data()) || !output->close())
    throw std::runtime_error("cannot encode " + format);
  return {bytes.begin(), bytes.end()};
}

/// Formats whose files keep 8 bits of each component as they are.
inline const std::vector<std::string> kLosslessFormats = {"png", "targa", "bmp", "tiff", "pnm"};
inline const std::vector<std::string> kReadFormats = {"png",  "jpeg", "openexr", "targa", "bmp",
                                                      "tiff", "hdr",  "webp",    "pnm"};

/// A file name of that format: only TGA needs one.
inline std::string file_name(const std::string& format) {
  return format == "targa" ? "picture.tga" : "picture.of_any_name";
}

}  // namespace lightbench::test
