#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/radiance/color_set.h"
#include "renderer/radiance/radiance_stack.h"

namespace lightbench {

/// A ByteStack of which only some layers of each texel are kept (surface-radiance thesis, 5.2).
///
/// The first kept sample of a texel is that of layer 0, the others follow with rising layers. Between two
/// neighbours, of colours a and b and at layers i < j, the colour at layer k, i <= k <= j, is, component by
/// component and in whole numbers,
///
///     (a * (j - k) + b * (k - i) + (j - i) / 2) / (j - i)
///
/// with a division that drops the remainder: linear, rounded to nearest, halves up. No operand is negative
/// and none reaches 2^24, so that GLSL's `int` gives the same bit for bit. From the last kept sample on its
/// colour stays, so that a texel of one colour keeps one sample.
struct PiecewiseStack {
  int width = 0;
  int height = 0;
  DirectionGrid grid;
  float scale = 1;                          ///< the radiance that stands for 1, as in ByteStack
  std::vector<std::uint32_t> first_sample;  ///< of each texel; its samples end where the next one's start
  std::vector<std::uint16_t> layers;        ///< of each sample
  /// Of each sample, the place of its colour in `colors`. Empty where there are more than kMaxMappedColors:
  /// `colors` then has each sample's colour itself, since a longer index would be no shorter than that.
  std::vector<std::uint16_t> color_indices;
  std::vector<Rgb8> colors;

  std::size_t texels() const { return first_sample.size(); }
  std::size_t samples_end(std::size_t texel) const {
    return texel + 1 < texels() ? first_sample[texel + 1] : layers.size();
  }
  const Rgb8& color(std::size_t sample) const {
    return color_indices.empty() ? colors[sample] : colors[color_indices[sample]];
  }
};
inline constexpr std::size_t kMaxMappedColors = 65536;

/// The decoder's formula for one component; `at` of `length` steps from a to b.
constexpr int interpolate(int a, int b, int at, int length) {
  return (a * (length - at) + b * at + length / 2) / length;
}

/// One value: a search among the texel's samples.
Rgb8 decode_piecewise(const PiecewiseStack& stack, std::size_t texel, int layer);
ByteStack decode_piecewise(const PiecewiseStack& stack);

}  // namespace lightbench
