#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lightbench {

/// The largest float of 16 bits, which pictures and baked radiance are kept in.
inline constexpr float kLargestHalf = 65504;

/// An image of interleaved components, row 0 on top.
template <typename Component>
struct BasicImage {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<Component> data;

  BasicImage() = default;
  BasicImage(int w, int h, int c, Component value = {})
      : width(w), height(h), channels(c), data(std::size_t(w) * std::size_t(h) * std::size_t(c), value) {}

  std::size_t pixel_count() const { return std::size_t(width) * std::size_t(height); }
  bool empty() const { return data.empty(); }

  std::span<Component> pixel(int x, int y) { return {data.data() + offset(x, y), std::size_t(channels)}; }
  std::span<const Component> pixel(int x, int y) const {
    return {data.data() + offset(x, y), std::size_t(channels)};
  }

  bool operator==(const BasicImage&) const = default;

 private:
  std::size_t offset(int x, int y) const {
    assert(x >= 0 && x < width && y >= 0 && y < height);
    return (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels);
  }
};

/// Linear radiance (RGB or RGBA, the alpha being coverage by objects), or any other float buffer.
using Image = BasicImage<float>;
/// 8-bit components as stored in a file: sRGB-encoded colour, linear alpha.
using Image8 = BasicImage<std::uint8_t>;

/// The first `channels` components of each pixel.
template <typename Component>
BasicImage<Component> first_channels(const BasicImage<Component>& image, int channels) {
  assert(channels <= image.channels);
  BasicImage<Component> result(image.width, image.height, channels);
  for (std::size_t i = 0; i < image.pixel_count(); ++i)
    for (int c = 0; c < channels; ++c)
      result.data[i * std::size_t(channels) + std::size_t(c)] =
          image.data[i * std::size_t(image.channels) + std::size_t(c)];
  return result;
}

}  // namespace lightbench
