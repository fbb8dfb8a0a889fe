#include <embree3/rtcore.h>
#include <fmt/format.h>

#include "renderer/path_tracer.h"

namespace lightbench {

std::string path_tracer_version() {
  return fmt::format("path tracer {}, Embree {}", kPathTracerVersion, RTC_VERSION_STRING);
}

std::uint64_t default_seed(PathTracedUse use) {
  return PathTracerOptions().seed + (use == PathTracedUse::variant ? 1 : 0);
}

std::vector<ParamSpec> path_tracer_params(PathTracedUse use) {
  const PathTracerOptions defaults;
  return {
      integer_param("bounces", defaults.bounces, 0, 16, "bounces of indirect light"),
      integer_param("samples", defaults.samples, 2, 65536,
                    "paths of each primary ray; with `noise`, the most"),
      number_param("noise", defaults.noise, 0, 255,
                   "estimated mean error, of 255, at which a tile of the picture is done before it has all "
                   "samples; 0: never"),
      integer_param("seed", int(default_seed(use)), 0, 2147483647,
                    "seed of the random choices; a variant and a reference of one seed share their noise"),
  };
}

std::vector<ParamPreset> path_tracer_presets() {
  return {
      {"two_bounces", {}, "the defaults: what POV-Ray's preset `physical` computes"},
      {"converged", {{"bounces", 16LL}}, "sixteen bounces: next to all light there is"},
  };
}

PathTracerOptions path_tracer_options(const ParamValues& params) {
  PathTracerOptions options;
  options.bounces = params.integer("bounces");
  options.samples = params.integer("samples");
  options.noise = params.number("noise");
  options.seed = std::uint64_t(params.integer("seed"));
  return options;
}

}  // namespace lightbench
