#pragma once

#include "renderer/technique.h"

namespace lightbench {

/// Light through a scene's wavy water, after "Rendering of Refractive Water Caustics by Level Maps" (the
/// water caustics thesis); parameter `method` chooses the way that it finds the surfaces.
Technique caustics_technique();

}  // namespace lightbench
