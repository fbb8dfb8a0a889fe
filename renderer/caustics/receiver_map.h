#pragma once

#include <cstddef>

#include "renderer/caustics/receiver_box.h"
#include "renderer/gbuffer.h"
#include "renderer/gl_framebuffer.h"
#include "renderer/gl_objects.h"

namespace lightbench {

class FrameContext;

/// Which colour of a receiver is lit.
enum class ReceiverColor {
  surface,  ///< its own, where it is seen
  map,      ///< that of its diffuse map
};

/// What a light shows of a receiver along the axis of its box: the position and the diffuse map of the water
/// caustics thesis (4.2.2), drawn at once. Texel x, y is at x along u and y along w of the box.
struct ReceiverMap {
  ReceiverBox box;
  std::size_t receiver = 0;  ///< which entity
  /// RGBA32F, a texel as techniques/caustics/places.glsl reads it: the depth in the box of the first surface
  /// below the water, 0 to 1 (less for what stands over the box, 2 where there is none); whose that is, so
  /// that others shade the receiver; by how much the plane of its triangle gets deeper along each side of the
  /// map, no more than the map's size.
  GlTexture places;
  GlTexture diffuse;  ///< RGBA16F: its linear colour, if that is asked for
};

ReceiverMap draw_receiver_map(FrameContext& frame, const ReceiverBox& box, std::size_t receiver, int size,
                              ReceiverColor color);

/// One plane of a box that is cut into slices.
struct Slice {
  int plane = 0;
  int slices = 0;
};

/// What belongs to a plane, into a target of RGBA8 and depth: white where it is the map's receiver, black
/// where it is others, or what stands over the box; else 0. With culling, clusters of triangles are left out
/// that miss it.
void draw_slice(FrameContext& frame, const ReceiverMap& map, const Slice& slice, const Framebuffer& target,
                FrustumCulling culling);

/// R32F, as large as the map: the depth at which what the map shows ends, which is the next surface behind it
/// of the same entity with its other side towards the light; -1e30 where there is none, as behind a sheet.
GlTexture draw_exits(FrameContext& frame, const ReceiverMap& map);

/// A depth buffer of the plane that each texel belongs to, of `slices` + 1, as plane_depth of
/// techniques/caustics/planes.glsl has it; 0 where the receiver is not seen.
GlTexture draw_plane_depths(FrameContext& frame, const ReceiverMap& map, int slices);

}  // namespace lightbench
