#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "renderer/rays.h"
#include "scene/scene.h"

namespace lightbench {

/// What nobody ever sees the inside of: connected parts of opaque meshes that are closed, or open only where
/// they stand on something, with no light and no emitter in their bounding box (so that a room that is a box
/// is none).
class Solids {
 public:
  explicit Solids(const Scene& scene);
  Solids(const Solids&) = delete;
  Solids& operator=(const Solids&) = delete;

  bool empty() const { return !rays_; }
  /// Whether a point lies within one, by what rays in the half-space of `normal` meet first. It should be off
  /// all surfaces.
  bool contain(const glm::vec3& point, const glm::vec3& normal) const;

 private:
  Scene scene_;
  std::optional<SceneRays> rays_;
};

}  // namespace lightbench
