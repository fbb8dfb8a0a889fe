#pragma once

#include "renderer/caustics/receiver_map.h"
#include "renderer/caustics/volumes.h"

namespace lightbench {

class FrameContext;

/// What is done with triangles of the water whose light falls on several surfaces.
enum class Straddling {
  split,  ///< each texel that their light may reach tells by its own depth whether it is in their volume
  drop,
};

struct HitOptions {
  int steps = 16;    ///< in which a ray is followed to where it lands, before ten bisections
  int slices = 100;  ///< of the box: a landing may be off the surface by the height of one of them
  Straddling straddling = Straddling::split;
};

/// As draw_level_map, but each triangle of the water is drawn once, where the rays of its corners land on the
/// position map (what the water caustics thesis proposes as future work).
GlTexture draw_hits(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                    const HitOptions& options);

}  // namespace lightbench
