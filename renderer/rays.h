#pragma once

#include <memory>
#include <optional>

#include <glm/vec3.hpp>

#include "scene/random_views.h"
#include "scene/scene.h"

namespace lightbench {

/// Exact ray queries against a scene (Embree). Cut-outs count: a hit where the cut-out texture is below 0.5
/// is no hit. Thread-safe after construction; keeps a reference to the scene.
class SceneRays {
 public:
  explicit SceneRays(const Scene& scene);
  SceneRays(const SceneRays&) = delete;
  SceneRays& operator=(const SceneRays&) = delete;
  ~SceneRays();

  std::optional<RayHit> closest_hit(const glm::vec3& origin, const glm::vec3& direction) const;
  /// Whether anything stands on the segment between the two points (shortened by a relative epsilon at both
  /// ends).
  bool occluded(const glm::vec3& from, const glm::vec3& to) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lightbench
