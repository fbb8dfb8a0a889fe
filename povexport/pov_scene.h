#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/params.h"
#include "povexport/pov_lights.h"
#include "povexport/pov_materials.h"
#include "scene/scene.h"

namespace lightbench {

/// Parameters and presets (physical, paper, direct) of the POV-Ray reference; ParamValues of these rows are
/// what `PovOptions` is made from.
std::span<const ParamSpec> pov_params();
std::span<const ParamPreset> pov_presets();

struct PovOptions {
  bool radiosity = true;
  double brightness = 1.0;
  int recursion_limit = 2;
  int count = 250;
  double error_bound = 0.25;
  double pretrace_start = 0.08;
  double pretrace_end = 0.01;
  double photon_spacing = 4e-4;  ///< of photons on a scene's water, over its longer side
  bool fresnel = false;          ///< whether a scene's water reflects a part of the light, and the background
  double parallel_height = 0;    ///< of what a camera with parallel rays sees; 0: a perspective one
  bool shadowless = false;
  bool estimate_noise = false;  ///< who renders it does so a second time, with `second_opinion`
};
PovOptions pov_options(const ParamValues& params);
/// Settings that are finer than these, so that what both images differ by tells how exact the first one is.
PovOptions second_opinion(const PovOptions& options);
/// Bounces of indirect light that these options give.
int pov_bounces(const PovOptions& options);

/// What all views of a scene share, at all times: mesh includes and textures under safe names of our own.
struct PovAssets {
  PovSpace space;
  std::map<std::string, std::string> includes;  ///< file name -> SDL text
  std::map<std::string, PovImage> images;       ///< file name (.png) -> where its pixels come from
  std::vector<std::string> warnings;            ///< what has no exact counterpart in POV-Ray
};
/// Throws Error for a scene without triangles.
PovAssets pov_assets(const Scene& scene);

/// The scene description of one view, deterministic to the byte, with the entities that move where they stand
/// at the scene's time. It includes the assets by their names.
/// `aspect` is width / height. Nothing of the scene stands in it but numbers. Who renders it puts the
/// declared Background behind the image by alpha, as `run_povray` does. Throws Error for numbers
/// that are not finite.
std::string pov_view(const Scene& scene, const PovAssets& assets, const Camera& camera, double aspect,
                     const PovOptions& options);

}  // namespace lightbench
