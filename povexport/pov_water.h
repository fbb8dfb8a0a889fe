#pragma once

#include "povexport/pov_lights.h"
#include "povexport/pov_writer.h"
#include "scene/scene.h"

namespace lightbench {

/// The scene's water at its time: the mesh that techniques use, with its normals, which refracts photons and
/// rays and absorbs along their ways; with `fresnel` it reflects what it does not let through. `scene.water`
/// must be there.
PovWriter pov_water(const Scene& scene, const PovSpace& space, bool fresnel);

}  // namespace lightbench
