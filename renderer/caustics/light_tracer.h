#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "renderer/caustics/receiver_box.h"
#include "scene/scene.h"

namespace lightbench {

/// Flux for each unit of area across the light's axis, over a receiver's box: size * size texels, x along u,
/// then y along w.
struct FluxMap {
  ReceiverBox box;
  int size = 0;
  std::vector<glm::vec3> texels;
};

struct LightTraceOptions {
  std::int64_t rays = 40'000'000;  ///< about so many; as many through each triangle of the water
  int map_size = 512;
  bool fresnel = false;
  std::uint64_t seed = 1;
  int threads = 1;  ///< the maps do not depend on it
};

struct LightTrace {
  std::vector<FluxMap> maps;  ///< of each entity
  std::int64_t rays = 0;
  glm::dvec3 sent{0};    ///< flux that enters the water
  glm::dvec3 landed{0};  ///< that reaches a surface, after what the water takes
  glm::dvec3 hidden{0};  ///< of it, on what another surface in the water stands over: no map shows it
};

/// Rays from one light through the water's mesh onto the scene's surfaces, exact for this path but for noise:
/// refracted at the mesh by its interpolated normals, stratified over each triangle. What stands above the
/// water shades it.
LightTrace trace_light(const Scene& scene, const Light& light, const LightTraceOptions& options,
                       const std::function<void(double)>& progress = nullptr);

}  // namespace lightbench
