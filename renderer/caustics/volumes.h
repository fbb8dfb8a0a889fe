#pragma once

#include <cstdint>
#include <vector>

#include "renderer/caustics/map_rays.h"
#include "renderer/caustics/occluder_map.h"
#include "renderer/caustics/receiver_map.h"
#include "renderer/gl_framebuffer.h"
#include "renderer/gl_program.h"

namespace lightbench {

/// Illumination volumes of one light and one receiver on the GPU.
struct Volumes {
  /// `least_area` of a triangle's image, in texels of the map: at folds it is 0, and flux over it without
  /// bound. `shade`: of draw_water_shade, null where nothing is above the water;
  /// `occluders`: null where only what lies along the axis stops light. Both must outlive this.
  Volumes(const MapRays& rays, const ReceiverMap& map, const glm::vec3& absorption, double least_area,
          const GlTexture* shade = nullptr, const OccluderMap* occluders = nullptr);

  /// Adds what programs with techniques/caustics/flux.glsl must be compiled with.
  ShaderDefines defines(ShaderDefines more = {}) const;
  /// Sets their uniforms and textures.
  void set_uniforms(const Program& program) const;

  int ray_count = 0;
  int triangle_count = 0;
  Buffer places, ways, spots;  ///< as MapRays has them: vec4, vec2 and vec2
  Buffer corners;              ///< three whole numbers of each triangle
  Buffer triangles;            ///< MapRays::Triangle
  VertexArray vertices;        ///< places, ways and spots, indexed by corners
  glm::vec3 absorption{0};
  float least_area = 0;  ///< in the world
  const GlTexture* shade = nullptr;
  const OccluderMap* occluders = nullptr;
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
