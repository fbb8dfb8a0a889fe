#pragma once

#include "renderer/caustics/receiver_map.h"

namespace lightbench {

class FrameContext;

inline constexpr unsigned kMapBlocksBlock = 6;  ///< of techniques/caustics/reach.glsl

/// How many blocks of 8 x 8 texels a map has along each side, the last of which may be smaller.
int blocks_along(const ReceiverMap& map);

/// Between which planes the receiver lies in each block of 8 x 8 texels of its map, for reach.glsl.
Buffer map_blocks(FrameContext& frame, const ReceiverMap& map, int slices);

}  // namespace lightbench
