#pragma once

#include <glm/vec2.hpp>

#include "renderer/gbuffer.h"

namespace lightbench {

class FrameContext;

/// What is kept of the surroundings of a camera.
struct SurroundOptions {
  /// Of a picture along the view, `wide_factor` times as wide as the frame to each side.
  float wide_factor = 1;
  glm::ivec2 wide_size{0};  ///< texels; 0: no such picture
  int cube_size = 0;        ///< texels along an edge of each of six pictures that are a cube; 0: no cube
  int layers = 1;           ///< surfaces kept along a ray, nearest first
  /// Behind the nearest surface keep only those whose shading normal, as modelled, faces the camera: others
  /// are mostly the far sides of the same solids.
  bool front_faces = true;
};

/// The tiles of one layer, side by side.
glm::ivec2 layer_size(const SurroundOptions& options);

/// A G-buffer of everything around the frame's camera: tiles side by side (renderer/shaders/tiles.glsl),
/// layers on top of one another, the first one lowest. Shaders that read it are compiled with
/// gbuffer_defines(), which say TILED, and it can be lit like any other. Texels without a surface have depth
/// 0. Times nothing.
GBuffer draw_surround(FrameContext& frame, const SurroundOptions& options);

}  // namespace lightbench
