#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace lightbench {

/// A triangle as the right-angled half of a rectangle: which of its corners comes to lie at the right angle,
/// at the end of the leg u, and at the end of the leg v.
struct TriangleHalf {
  std::uint32_t triangle;
  std::array<std::uint8_t, 3> corners;
};

/// A piece of surface that becomes a rectangle, from two triangles that share the diagonal, or half of one.
struct SurfaceChart {
  TriangleHalf first;
  std::optional<TriangleHalf> second;  ///< its right angle is opposite the first's
  double u_length;                     ///< world space, of the legs; u_length >= v_length > 0
  double v_length;
};

/// The corners in world space.
std::array<glm::dvec3, 3> world_corners(const Mesh& mesh, const glm::mat4& transform, std::uint32_t triangle);

/// Cuts an object's surface into charts. Two triangles make one when they share an edge (vertices may be
/// doubled), belong to one part, have the same shading normals at the shared vertices, are coplanar to 10
/// degrees, and form nearly a parallelogram with no angle below 45 degrees; the most rectangular pairs come
/// first. Of any other triangle the longest edge becomes the hypotenuse. Triangles without area (to the
/// rounding of floats) or with corners that are not finite are in no chart.
std::vector<SurfaceChart> find_charts(const Mesh& mesh, const glm::mat4& transform);

}  // namespace lightbench
