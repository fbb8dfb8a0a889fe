#pragma once

#include "renderer/radiance/texel_values.h"

namespace lightbench {

/// Some of an object's texels: blocks of 4 x 4, as RGTC compresses them, side by side in a stack.
struct PcaSample {
  HalfStack stack;
  TexelPlaces places;  ///< that count
};

/// `blocks` of them, or all that there are, taken at random but the same each time; each has texels that
/// count. `places` are those of the stack's texels that count.
PcaSample sample_blocks(const HalfStack& stack, const TexelPlaces& places, std::size_t blocks);

}  // namespace lightbench
