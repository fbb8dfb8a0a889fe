#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "renderer/rays.h"

/// What closes a mesh that stands on something: furniture is often modelled without the side that nobody
/// sees.
namespace lightbench {

using Triangles = std::vector<glm::uvec3>;

/// Closed chains of the edges that have a triangle on one side only, against the triangles' winding, so that
/// what fills them is wound as those are. None where an edge has more than two triangles, or two that are
/// wound differently; no chains where the mesh is closed.
std::optional<std::vector<std::vector<std::uint32_t>>> open_rims(const Triangles& triangles);

/// A fan about the middle of a rim, three corners for each triangle: where the rim is flat, and so small or
/// so near to opaque surfaces everywhere within it that no light passes.
std::optional<std::vector<glm::vec3>> lid_of(const std::vector<glm::vec3>& rim, const SceneRays& scene);

}  // namespace lightbench
