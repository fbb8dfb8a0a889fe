#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace lightbench {

/// The box around a receiver that looks towards the light (the water caustics thesis, 4.2.1): v is against
/// the way the light takes below flat water. What it takes from light is kept in maps over u and w.
struct ReceiverBox {
  glm::dvec3 u{1, 0, 0}, v{0, 1, 0}, w{0, 0, 1};  ///< unit, perpendicular, right-handed
  glm::dvec3 center{0};                           ///< in the world
  glm::dvec3 size{0};                             ///< along u, v and w

  /// A point of the world in the maps: x and y are 0 to 1 along u and w, z is 0 on the side of the light and
  /// 1 on the far side.
  glm::dvec3 to_map(const glm::dvec3& point) const;
  glm::dvec3 from_map(const glm::dvec3& place) const;
  /// The same for directions and differences of points.
  glm::dvec3 direction_to_map(const glm::dvec3& direction) const;
};

/// Around all vertices of an entity, each side a ten-thousandth of the largest wider, so that nothing lies on
/// its border. `axis` is the unit way of the light.
ReceiverBox receiver_box(const Scene& scene, std::size_t entity, const glm::dvec3& axis);
/// Along the light that flat water lets through to the entity's middle.
ReceiverBox receiver_box(const Scene& scene, std::size_t entity, const Light& light);

}  // namespace lightbench
