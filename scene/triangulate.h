#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/ear_clipper.h"

namespace lightbench {

/// Cuts a polygon of n >= 3 corners, convex or not, into n - 2 triangles of indices into `polygon` with its
/// sense of rotation. A convex polygon becomes a fan around its first corner. One that touches itself, as
/// where a bridge leads to a hole, is covered exactly, and some triangles have no area (scene/ear_clipper.h).
/// One whose edges cross, or that takes more than what is left of the budget, gives some triangles, and
/// false.
bool triangulate(std::span<const glm::vec3> polygon, std::vector<glm::uvec3>& triangles,
                 ClippingBudget& budget);

}  // namespace lightbench
