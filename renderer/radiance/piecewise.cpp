#include "renderer/radiance/piecewise.h"

#include <algorithm>

#include "renderer/radiance/ramp.h"
#include "renderer/radiance/texel_block.h"

namespace lightbench {
namespace {

void decode_texel(const PiecewiseStack& stack, std::size_t texel, std::span<Rgb8> layers) {
  std::size_t sample = stack.first_sample[texel];
  for (; sample + 1 < stack.samples_end(texel); ++sample) {
    const int from = stack.layers[sample], to = stack.layers[sample + 1];
    Ramp ramp(stack.color(sample), stack.color(sample + 1), to - from);
    for (int layer = from; layer < to; ++layer, ramp.step()) layers[std::size_t(layer)] = ramp.color();
  }
  std::ranges::fill(layers.subspan(stack.layers[sample]), stack.color(sample));
}

}  // namespace

Rgb8 decode_piecewise(const PiecewiseStack& stack, std::size_t texel, int layer) {
  const auto begin = stack.layers.begin() + stack.first_sample[texel];
  const auto end = stack.layers.begin() + std::ptrdiff_t(stack.samples_end(texel));
  const auto after = std::upper_bound(begin, end, layer);
  const auto sample = std::size_t(after - stack.layers.begin()) - 1;
  const Rgb8& a = stack.color(sample);
  if (after == end) return a;
  const Rgb8& b = stack.color(sample + 1);
  const int from = stack.layers[sample], length = *after - from;
  Rgb8 color{};
  for (std::size_t c = 0; c < 3; ++c) color[c] = std::uint8_t(interpolate(a[c], b[c], layer - from, length));
  return color;
}

ByteStack decode_piecewise(const PiecewiseStack& stack) {
  ByteStack result{stack.width, stack.height, stack.grid, stack.scale, {}};
  result.texels.resize(result.layer_size() * std::size_t(stack.grid.layers()));
  for (std::size_t first = 0; first < stack.texels(); first += TexelBlock::kMaxTexels) {
    TexelBlock block(first, result);
    for (std::size_t i = 0; i < block.texels(); ++i) decode_texel(stack, first + i, block.layers_of(i));
    block.scatter(result);
  }
  return result;
}

}  // namespace lightbench
