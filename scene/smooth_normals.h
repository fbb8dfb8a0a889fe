#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace lightbench {

/// Shading normals of the corners of triangles, three a triangle. A corner's normal is the mean, weighted
/// with area, of its own triangle and of those that meet it at that point at an angle of at most
/// `crease_angle` (radians). `triangles` are indices into `points`, where each point in space stands once;
/// none may have zero area. Corners of the same smooth patch get the same bits. Only those with `wanted` are
/// computed; the others are 0.
std::vector<glm::vec3> smooth_normals(std::span<const glm::vec3> points,
                                      std::span<const glm::uvec3> triangles, float crease_angle,
                                      const std::vector<bool>& wanted);

}  // namespace lightbench
