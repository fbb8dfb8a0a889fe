#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace lightbench {

/// A rotation about x, then y, then z, right-handed; exact for multiples of 90 degrees, so that turned boxes
/// stay boxes.
glm::dmat4 rotation_degrees(const glm::dvec3& degrees);

}  // namespace lightbench
