#pragma once

#include "renderer/caustics/receiver_map.h"
#include "renderer/caustics/volumes.h"

namespace lightbench {

class FrameContext;

/// How a fragment of a plane finds out whether its texel belongs to it.
enum class PlaneTest {
  equal,    ///< by a depth buffer that holds the planes
  discard,  ///< in the shader, as in the thesis
};

/// Which planes the volumes are cut by.
enum class Slicing {
  local,            ///< each by those that the receiver lies on where its light passes (volume_cuts.h)
  smart,            ///< all by those that a texel of the position map belongs to, found on the GPU
  smart_read_back,  ///< the same, found from the position map read back
  uniform,          ///< all by all
};

struct LevelMapOptions {
  int slices = 100;  ///< the box is cut into so many, by one plane more
  PlaneTest test = PlaneTest::equal;
  Slicing slicing = Slicing::local;
};
inline constexpr int kMaxSlices = 8190;  ///< what plane_depth of techniques/caustics/planes.glsl tells apart

/// RGBA32F, as large as the position map: the flux that its texels take for each unit of area across the
/// light's axis, linear RGB; a counts the volumes whose area was raised to the least.
GlTexture draw_level_map(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes,
                         const LevelMapOptions& options);

/// Adds what all volumes send through one plane to a target of RGBA32F, on texels tilted as the position map
/// has it; with occluders only on texels that belong to the plane.
void draw_plane(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes, int plane, int slices,
                const Framebuffer& target);

/// How many texels of the position map belong to each plane; reads it back.
std::vector<std::size_t> texels_by_plane(const ReceiverMap& map, int slices);

/// The planes that any do, in order.
std::vector<std::uint32_t> used_planes(const ReceiverMap& map, int slices);

}  // namespace lightbench
