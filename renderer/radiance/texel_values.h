#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "renderer/radiance/radiance_stack.h"

/// Baked texels as vectors, for encoders.
namespace lightbench {

/// Places of texels in a layer: y * width + x.
using TexelPlaces = std::vector<std::uint32_t>;

/// The values of some texels, one column each: what a ByteStack has for them, 0..255, but not yet rounded.
/// Rows are planes of a component over the grid's layers.
Eigen::MatrixXf texel_values(const HalfStack& stack, std::span<const std::uint32_t> places);

/// Calls `handle(first, block, values)` for the places block after block, where `first` is that of the
/// block's first place among them; values of a block fit into a core's cache.
template <typename Handle>
void for_texel_blocks(const HalfStack& stack, const TexelPlaces& places, const Handle& handle) {
  constexpr std::size_t kBlock = 256;
  for (std::size_t first = 0; first < places.size(); first += kBlock) {
    const std::span block = std::span(places).subspan(first, std::min(kBlock, places.size() - first));
    handle(first, block, texel_values(stack, block));
  }
}

/// What a fit should aim at. A value at an end of the scale, once it is rounded, is open: it may as well be
/// anything beyond, since decoders clamp; so where what was fitted is beyond an open value, it is that.
inline constexpr auto target_of = [](float value, float fitted) {
  const float above = std::max(value, fitted), below = std::min(value, fitted);
  return value >= 254.5f ? above : value < 0.5f ? below : value;
};

}  // namespace lightbench
