#pragma once

#include <cstddef>
#include <optional>

#include <glm/vec3.hpp>

#include "renderer/paths/path_scene.h"

namespace lightbench {

/// What a ray meets from `near` on.
struct SurfaceHit {
  std::size_t entity;
  glm::dvec3 position;
  SurfacePoint surface;
};
std::optional<SurfaceHit> closest_surface(const PathScene& scene, const glm::vec3& origin,
                                          const glm::vec3& direction, float near = 0);

}  // namespace lightbench
