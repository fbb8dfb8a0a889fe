#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/random_views.h"
#include "scene/scene.h"

namespace lightbench {

/// Tells which places the lights of a scene reach, by shadow rays. An area light counts as its middle.
/// Surfaces that emit count only in a scene that has no lights, and the background only in a scene that has
/// neither.
class LightReach {
 public:
  LightReach(const Scene& scene, const ClosestHit& closest_hit);

  /// Whether the scene has anything that could light it; otherwise no place says anything.
  bool has_light() const { return !lights_.empty() || sky_; }

  /// Whether a white surface at `point`, whose front looks along the unit `normal`, would be seen in the
  /// light: not black beside white.
  bool lit(const glm::vec3& point, const glm::vec3& normal) const;

 private:
  struct Ray {
    glm::vec3 direction;
    float distance;  ///< to the light; infinite for one without a place
    float radiance;  ///< that the surface would show if nothing stood between
  };
  Ray ray_to(const Light& light, const glm::vec3& point, const glm::vec3& normal) const;
  bool reached(const Ray& ray, const glm::vec3& point, const glm::vec3& normal) const;
  bool sees_sky(const glm::vec3& point, const glm::vec3& normal) const;

  const ClosestHit& closest_hit_;
  std::vector<Light> lights_;  ///< points, spots and directional lights
  bool sky_ = false;
  float offset_;  ///< of the origin of a shadow ray from its surface
};

}  // namespace lightbench
