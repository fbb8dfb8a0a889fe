#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace lightbench {

/// The distance from p to the nearest triangle of any entity; infinite in an empty scene. Visits all
/// triangles whose mesh may be near enough: milliseconds for 10^5 triangles.
float distance_to_nearest_surface(const Scene& scene, const glm::vec3& p);

/// The eight corners of a box that is not empty.
std::vector<glm::vec3> corners(const Bounds& bounds);

/// A point in the space that `transform` maps to.
glm::vec3 transform_point(const glm::mat4& transform, const glm::vec3& p);

}  // namespace lightbench
