#pragma once

#include <string>
#include <vector>

#include "povexport/pov_lights.h"
#include "povexport/pov_writer.h"
#include "scene/scene.h"

namespace lightbench {

/// The scene's water at its time: the mesh that techniques use, with its normals, which refracts photons and
/// rays and absorbs along their ways. `scene.water` must be there.
PovWriter pov_water(const Scene& scene, const PovSpace& space);

/// What of the water has no exact counterpart, as sentences for the report.
std::vector<std::string> pov_water_warnings(const Scene& scene);

}  // namespace lightbench
