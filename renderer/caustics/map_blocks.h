#pragma once

#include "renderer/caustics/receiver_map.h"

namespace lightbench {

class FrameContext;

inline constexpr unsigned kMapBlocksBlock = 6;  ///< of techniques/caustics/reach.glsl

/// Between which planes the receiver lies in each block of 8 x 8 texels of its map, and in blocks of
/// ever more of them, for reach.glsl.
Buffer map_blocks(FrameContext& frame, const ReceiverMap& map, int slices);

}  // namespace lightbench
