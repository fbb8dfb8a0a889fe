#pragma once

#include "renderer/caustics/receiver_map.h"
#include "renderer/caustics/volumes.h"

namespace lightbench {

class FrameContext;

/// What is drawn into each slice image.
enum class SliceDrawing {
  whole,     ///< all that stands in the water, as in the thesis
  clusters,  ///< clusters of at most 1024 triangles that the slice may hold
};

struct VolumetricOptions {
  int slices = 100;  ///< of the box, by one plane more
  SliceDrawing drawing = SliceDrawing::whole;
};

/// What draw_level_map gives, bit for bit but for a, by the method that it is to be better than (the water
/// caustics thesis, 5.2.1): an image of the receiver for each plane, all kept, and each multiplied with the
/// light in it; the first that covers a texel gives it its light. a is 1 where anything stands.
GlTexture draw_volumetric(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                          const VolumetricOptions& options);

}  // namespace lightbench
