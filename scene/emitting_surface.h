#pragma once

#include "scene/scene.h"

namespace lightbench {

/// Adds an area light as what it is in the world: a quad or triangle of its own, named after the light, that
/// emits the radiance colour * power to both sides (so with an emitter's cosine) and reflects nothing. It
/// hides what is behind it, and only indirect light gathers it.
void add_emitting_surface(Scene& scene, const Light& light);

}  // namespace lightbench
