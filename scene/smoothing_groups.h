#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace lightbench {

/// Shading normals of the corners of triangles, three a triangle, from smoothing groups (`s` of OBJ files):
/// the mean of all triangles of the same group that meet at that point, however sharp the edges between them.
/// Each is weighted with its angle there, as Blender does, so that it does not matter how a face is cut.
/// `groups` are of the triangles; group 0 is flat. `triangles` are indices into `points`, where each point in
/// space stands once; none may have zero area. Only those with `wanted` are computed; the others are 0.
std::vector<glm::vec3> smoothing_group_normals(std::span<const glm::vec3> points,
                                               std::span<const glm::uvec3> triangles,
                                               std::span<const std::int32_t> groups,
                                               const std::vector<bool>& wanted);

}  // namespace lightbench
