#include "base/picture_pixels.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"

namespace lightbench {
namespace {

template <typename Component>
constexpr OIIO::TypeDesc::BASETYPE kType = sizeof(Component) == 1 ? OIIO::TypeDesc::UINT8
                                                                  : OIIO::TypeDesc::FLOAT;

/// The range of the file's channels that has all those of a picture.
struct ChannelRange {
  int begin;
  int end;

  explicit ChannelRange(const PictureChannels& picture)
      : begin(std::ranges::min(picture.indices)), end(std::ranges::max(picture.indices) + 1) {}
  int count() const { return end - begin; }
};

void check_read(bool read, OIIO::ImageInput& input, const std::filesystem::path& file) {
  if (read && !input.has_error()) return;  // of TIFF, it says that it read what is not there
  const std::string reason = one_line(input.geterror());
  throw Error("truncated or damaged image: " + (reason.empty() ? "its pixels end too early" : reason),
              file.string());
}

bool fills_display(const OIIO::ImageSpec& spec) {
  return spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width &&
         spec.height == spec.full_height;
}

/// The components of a pixel from the channels of the range.
template <typename Component>
void pick(const Component* channels, const PictureChannels& picture, const ChannelRange& range,
          Component* pixel) {
  for (std::size_t i = 0; i < picture.indices.size(); ++i)
    pixel[i] = channels[picture.indices[i] - range.begin];
}

/// Some lines of the data window, all of its width.
template <typename Component>
struct Strip {
  std::int64_t top;
  std::int64_t bottom;  // behind the last line
  std::vector<Component> data;
};

/// Lines that are read at once: whole tiles, or whole blocks of what OpenEXR packs together in most files,
/// but fewer where the channels of the picture lie far apart in the file.
std::int64_t strip_height(const OIIO::ImageSpec& spec, const ChannelRange& range, std::size_t component,
                          const std::filesystem::path& file) {
  constexpr std::int64_t kLines = 64, kBytes = std::int64_t(64) << 20, kMostBytes = std::int64_t(2) << 30;
  const std::int64_t line =
      std::max<std::int64_t>(std::int64_t(spec.width) * range.count() * std::int64_t(component), 1);
  if (spec.tile_width == 0) return std::clamp<std::int64_t>(kBytes / line, 1, kLines);
  const std::int64_t height = std::min(std::max(spec.tile_height, 1), spec.height);
  if (height * line > kMostBytes)
    throw Error(
        fmt::format("a row of its tiles takes {} bytes, with the {} channels between the first and the "
                    "last one of the picture",
                    height * line, range.count()),
        file.string());
  return height;
}

template <typename Component>
bool read_strip(Strip<Component>& strip, OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
                const PictureChannels& picture) {
  const ChannelRange range(picture);
  const int part = int(picture.part), top = int(strip.top), bottom = int(strip.bottom);
  strip.data.resize(std::size_t(bottom - top) * std::size_t(spec.width) * std::size_t(range.count()));
  if (spec.tile_width == 0)
    return input.read_scanlines(part, 0, top, bottom, 0, range.begin, range.end, kType<Component>,
                                strip.data.data());
  return input.read_tiles(part, 0, spec.x, spec.x + spec.width, top, bottom, 0, 1, range.begin, range.end,
                          kType<Component>, strip.data.data());
}

/// Copies what of the strip lies in the display window.
template <typename Component>
void place(const Strip<Component>& strip, const OIIO::ImageSpec& spec, const PictureChannels& picture,
           BasicImage<Component>& image) {
  const ChannelRange range(picture);
  const std::int64_t left = spec.full_x, top = spec.full_y;
  const std::int64_t begin = std::max<std::int64_t>(spec.x, left);
  const std::int64_t end = std::min(std::int64_t(spec.x) + spec.width, left + spec.full_width);
  for (std::int64_t y = std::max(strip.top, top); y < std::min(strip.bottom, top + spec.full_height); ++y)
    for (std::int64_t x = begin; x < end; ++x) {
      const std::int64_t place = (y - strip.top) * spec.width + (x - spec.x);
      pick(&strip.data[std::size_t(place * range.count())], picture, range,
           image.pixel(int(x - left), int(y - top)).data());
    }
}

template <typename Component>
void clear_channels(BasicImage<Component>& image, std::size_t channels) {
  for (std::size_t i = 0; i < image.data.size(); i += std::size_t(image.channels))
    std::fill_n(&image.data[i], channels, Component{});
}

template <typename Component>
void read_in_strips(BasicImage<Component>& image, OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
                    const PictureChannels& picture, const std::filesystem::path& file) {
  clear_channels(image, picture.indices.size());
  const std::int64_t data_bottom = std::int64_t(spec.y) + spec.height;
  const std::int64_t display_bottom = std::int64_t(spec.full_y) + spec.full_height;
  const std::int64_t height = strip_height(spec, ChannelRange(picture), sizeof(Component), file);
  Strip<Component> strip{};
  for (strip.top = spec.y; strip.top < std::min(data_bottom, display_bottom); strip.top += height) {
    strip.bottom = std::min(strip.top + height, data_bottom);
    if (strip.bottom <= spec.full_y) continue;
    check_read(read_strip(strip, input, spec, picture), input, file);
    place(strip, spec, picture, image);
  }
}

bool follow_each_other(const std::vector<int>& indices) {
  return std::ranges::adjacent_find(indices, [](int a, int b) { return b != a + 1; }) == indices.end();
}

}  // namespace

template <typename Component>
void read_pixels(BasicImage<Component>& image, OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
                 const PictureChannels& picture, const std::filesystem::path& file) {
  if (!fills_display(spec) || !follow_each_other(picture.indices)) {
    read_in_strips(image, input, spec, picture, file);
    return;
  }
  const ChannelRange range(picture);
  const auto stride = OIIO::stride_t(std::size_t(image.channels) * sizeof(Component));
  check_read(input.read_image(int(picture.part), 0, range.begin, range.end, kType<Component>,
                              image.data.data(), stride),
             input, file);
}

template void read_pixels(Image&, OIIO::ImageInput&, const OIIO::ImageSpec&, const PictureChannels&,
                          const std::filesystem::path&);
template void read_pixels(Image8&, OIIO::ImageInput&, const OIIO::ImageSpec&, const PictureChannels&,
                          const std::filesystem::path&);

}  // namespace lightbench
