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

/// A light as POV-Ray's light_source. Throws Error for area lights.
PovWriter pov_light(const Light& light, const PovSpace& space, bool shadowless);

/// What of a light has no exact counterpart, as a sentence for the report, or nothing.
std::vector<std::string> pov_light_warnings(const Light& light);

/// amplitude * 2 / (1 + (d / distance)^power).
struct FadeFit {
  double amplitude;
  double distance;
  double power;
  double worst;  ///< largest error over 0..2 radius, of the value at distance 0
};
/// The fade nearest to saturate(1 - d / radius)^2 in the mean square over the lit ball's radius.
FadeFit fit_radius_attenuation(double radius);

}  // namespace lightbench
