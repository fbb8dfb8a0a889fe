#pragma once

#include "renderer/technique.h"

namespace lightbench {

/// Draws what was baked: the radiance of every texel of the scene's surfaces in many directions, so that a
/// picture costs the same however costly its light was (surface-radiance thesis).
Technique surface_radiance_technique();

}  // namespace lightbench
