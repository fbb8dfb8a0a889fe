#pragma once

#include <string>
#include <vector>

#include "povexport/pov_writer.h"
#include "scene/scene.h"

namespace lightbench {

/// Where a light stands: the scene's bounds (a directional light stands outside of them) and POV-Ray's units
/// for one unit of the scene.
struct PovSpace {
  Bounds bounds;
  double scale = 1;
};

struct PovLightOptions {
  bool shadowless = false;
  bool photons = false;  ///< sends photons through what refracts them
};

/// A light as POV-Ray's light_source: one for each of its points and each part of its attenuation. (POV-Ray's
/// own area_light weighs its points otherwise where they are in part hidden, and is a point light to the rays
/// that gather indirect light.)
PovWriter pov_light(const Light& light, const PovSpace& space, const PovLightOptions& options = {});

/// What of a light has no exact counterpart, as a sentence for the report, or nothing.
std::vector<std::string> pov_light_warnings(const Light& light);

/// What stands for saturate(1 - (d / radius)^2) in POV-Ray, at d = `part` radii: a sum of fades, some of them
/// dark.
double radius_attenuation_by_fades(double part);
/// The largest difference between the two, where 1 is the light at its place: looked for from a
/// ten-thousandth of the radius to ten thousand of them.
double radius_attenuation_error();

}  // namespace lightbench
