#include <algorithm>

#include "povexport/pov_scene.h"

namespace lightbench {
namespace {

constexpr int kMaxCount = 1600;  // POV-Ray's table of directions

}  // namespace

std::span<const ParamSpec> pov_params() {
  static const std::vector<ParamSpec> specs = {
      boolean_param("radiosity", true, "gather indirect light"),
      number_param("brightness", 1.0, 0, 100, "factor of the gathered light; compounds with each bounce"),
      integer_param("recursion_limit", 2, 1, 20, "bounces of indirect light"),
      integer_param("count", 250, 1, kMaxCount, "rays of one gathering"),
      number_param("error_bound", 0.25, 0.001, 100, "how far gathered values are reused; lower is finer"),
      number_param("pretrace_start", 0.08, 0.0001, 1, "block size of the first pretrace, of the width"),
      number_param("pretrace_end", 0.01, 0.0001, 1, "block size of the last pretrace, of the width"),
      number_param("photon_spacing", 4e-4, 1e-5, 0.1,
                   "between the photons that fall on a scene's water, as a share of its longer side"),
      boolean_param("fresnel", false,
                    "whether a scene's water reflects a part of the light, and the background"),
      boolean_param("shadowless", false, "lights cast no shadows"),
      boolean_param("estimate_noise", false,
                    "render a second time, with twice the rays and half the error bound, to tell how exact "
                    "the reference is; takes about three times as long"),
  };
  return specs;
}

std::span<const ParamPreset> pov_presets() {
  static const std::vector<ParamPreset> presets = {
      {"physical", {}, "two bounces that keep the energy of a path tracer"},
      {"paper",
       {{"brightness", 2.4}, {"shadowless", true}},
       "the image-space-radiosity thesis, listing 9 as printed: no shadows, and too much light from the "
       "second bounce on"},
      {"direct", {{"radiosity", false}}, "direct light and shadows only"},
  };
  return presets;
}

PovOptions pov_options(const ParamValues& params) {
  PovOptions options;
  options.radiosity = params.boolean("radiosity");
  options.brightness = params.number("brightness");
  options.recursion_limit = params.integer("recursion_limit");
  options.count = params.integer("count");
  options.error_bound = params.number("error_bound");
  options.pretrace_start = params.number("pretrace_start");
  options.pretrace_end = params.number("pretrace_end");
  options.photon_spacing = params.number("photon_spacing");
  options.fresnel = params.boolean("fresnel");
  options.shadowless = params.boolean("shadowless");
  // Direct light alone is not sampled: a second rendering would be the same.
  options.estimate_noise = params.boolean("estimate_noise") && options.radiosity;
  return options;
}

PovOptions second_opinion(const PovOptions& options) {
  PovOptions finer = options;
  finer.count = std::min(2 * options.count, kMaxCount);
  finer.error_bound = options.error_bound / 2;
  finer.pretrace_end = options.pretrace_end / 2;
  return finer;
}

int pov_bounces(const PovOptions& options) {
  return options.radiosity ? options.recursion_limit : 0;
}

}  // namespace lightbench
