#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "scene/scene.h"

namespace lightbench {

/// A mesh's own UVs in texels of a texture: the box around all of them is stretched to lie between the
/// outermost texel centres, with the smallest u at column 0 and the greatest v at row 0.
struct OwnUvs {
  std::vector<std::array<glm::vec2, 3>> coordinates;  ///< of each triangle's corners
  std::vector<std::uint32_t> charts;  ///< of each triangle; those that share an edge, in position and UV, are
                                      ///< of one chart
};

/// `in_no_chart` are triangles without area. `uvs` must be finite.
OwnUvs place_own_uvs(const Mesh& mesh, glm::ivec2 size, const std::vector<bool>& in_no_chart);

/// The size that gives as many texels to a unit of length, in the mean over the surface along u and along v.
glm::dvec2 size_for_own_uvs(const Mesh& mesh, const glm::mat4& transform, double texels_per_unit);

/// Why UVs can serve at no size, or empty: there are none; some lie outside [0, 1], as those of textures that
/// repeat do; or a triangle has area in space but none in its UVs.
std::string problem_of_uvs(const Mesh& mesh, const std::vector<bool>& in_no_chart);

}  // namespace lightbench
