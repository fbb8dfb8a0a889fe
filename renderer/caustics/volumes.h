#pragma once

#include <cstdint>
#include <vector>

#include "renderer/caustics/map_rays.h"
#include "renderer/caustics/receiver_map.h"
#include "renderer/gl_framebuffer.h"

namespace lightbench {

class Program;

/// Illumination volumes of one light and one receiver on the GPU.
struct Volumes {
  /// `least_area` of a triangle's image, in texels of the map: at folds it is 0, and flux over it without
  /// bound.
  Volumes(const MapRays& rays, const ReceiverMap& map, const glm::vec3& absorption, double least_area);

  /// Sets the uniforms of techniques/caustics/volume.frag.glsl and landing.frag.glsl.
  void set_uniforms(const Program& program) const;

  int ray_count = 0;
  int triangle_count = 0;
  Buffer places, ways;   ///< as MapRays has them, vec4 and vec2
  Buffer corners;        ///< three whole numbers of each triangle
  Buffer triangles;      ///< MapRays::Triangle
  VertexArray vertices;  ///< places and ways, indexed by corners
  glm::vec3 absorption{0};
  float map_area = 0;    ///< in the world
  float least_area = 0;  ///< in the world
};

/// Whatever is drawn is added to the target, everywhere.
void set_adding_state();

/// As glDrawElementsIndirect reads it, and its beginning glDrawArraysIndirect: how much is drawn is known to
/// shaders alone.
struct DrawVolumes {
  std::uint32_t indices = 0;
  std::uint32_t instances = 0;
  std::uint32_t first_index = 0;
  std::uint32_t base_vertex = 0;
  std::uint32_t base_instance = 0;
};

inline constexpr unsigned kDrawVolumesBlock = 5;  ///< of techniques/caustics/draw_volumes.glsl

}  // namespace lightbench
