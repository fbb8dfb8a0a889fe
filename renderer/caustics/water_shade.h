#pragma once

#include <optional>

#include "renderer/gl_objects.h"
#include "scene/scene.h"

namespace lightbench {

class FrameContext;

/// Whether anything stands above the level of the scene's water.
bool reaches_above_water(const FrameContext& frame);

/// Where a light reaches the level of the scene's water: 1, and 0 where something above keeps it off; over
/// the water's rectangle, x along x and y along z, to be looked up at WaterLight::spots. Nothing where
/// nothing is above.
std::optional<GlTexture> draw_water_shade(FrameContext& frame, const Light& light);

}  // namespace lightbench
