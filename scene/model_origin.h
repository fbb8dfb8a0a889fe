#pragma once

#include <glm/vec3.hpp>

#include "scene/obj_parser.h"

namespace lightbench {

/// How many times its size a model may lie away from an origin: at this distance 32-bit floats still tell
/// 2^18 places along it from one another.
inline constexpr double kFarAway = 64;

/// The point that a model's coordinates are best taken from: 0, or one in the middle of a model that lies far
/// away for its size.
glm::dvec3 model_origin(const ObjData& data);

}  // namespace lightbench
