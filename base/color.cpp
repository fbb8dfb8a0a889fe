#include "base/color.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace lightbench {
namespace {

std::uint8_t round_to_8_bits(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

bool is_alpha(std::size_t component, int channels) {
  return channels == 4 && component % 4 == 3;
}

}  // namespace

float srgb_encode(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float srgb_decode(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float srgb_decode8(std::uint8_t encoded) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (int i = 0; i < 256; ++i) values[std::size_t(i)] = srgb_decode(float(i) / 255.0f);
    return values;
  }();
  return table[encoded];
}

Image8 to_srgb8(const Image& linear) {
  Image8 result(linear.width, linear.height, linear.channels);
  for (std::size_t i = 0; i < linear.data.size(); ++i) {
    const float value = std::isnan(linear.data[i]) ? 0.0f : std::clamp(linear.data[i], 0.0f, 1.0f);
    result.data[i] = round_to_8_bits(is_alpha(i, linear.channels) ? value : srgb_encode(value));
  }
  return result;
}

Image from_srgb8(const Image8& encoded) {
  Image result(encoded.width, encoded.height, encoded.channels);
  for (std::size_t i = 0; i < encoded.data.size(); ++i)
    result.data[i] =
        is_alpha(i, encoded.channels) ? float(encoded.data[i]) / 255.0f : srgb_decode8(encoded.data[i]);
  return result;
}

double mean_luminance(const Image& linear) {
  assert(linear.channels >= 3);
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < linear.pixel_count(); ++i) {
    const float* pixel = &linear.data[i * std::size_t(linear.channels)];
    const double weight = linear.channels > 3 ? pixel[3] : 1;
    sum += weight * (0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]);
    weights += weight;
  }
  return weights > 0 ? sum / weights : 0;
}

std::ptrdiff_t first_non_finite(const Image& image) {
  const auto found =
      std::find_if(image.data.begin(), image.data.end(), [](float v) { return !std::isfinite(v); });
  return found == image.data.end() ? -1 : found - image.data.begin();
}

Image box_downsample(const Image& image, int factor) {
  assert(factor >= 1 && image.width % factor == 0 && image.height % factor == 0);
  if (factor == 1) return image;
  Image result(image.width / factor, image.height / factor, image.channels);
  const float weight = 1.0f / float(factor * factor);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto source = image.pixel(x, y);
      const auto target = result.pixel(x / factor, y / factor);
      for (std::size_t c = 0; c < source.size(); ++c) target[c] += source[c] * weight;
    }
  return result;
}

}  // namespace lightbench
