#include "pipeline/references/path_tracer.h"

#include "base/process.h"
#include "base/stopwatch.h"
#include "renderer/path_tracer.h"

namespace lightbench {
namespace {

std::map<std::string, double> rates_of(const std::vector<RayRate>& rays) {
  std::map<std::string, double> rates;
  for (const RayRate& rate : rays)
    if (rate.seconds > 0) rates[rate.name] = double(rate.rays) / rate.seconds;
  return rates;
}

ReferenceImage run_path_tracer(const ReferenceRequest& request, const Scene& scene) {
  const Stopwatch watch;
  const double cpu_start = own_cpu_seconds();
  PathTracedImage made = trace_paths(scene, request.view, request.width, request.height, request.samples,
                                     path_tracer_options(request.params));
  ReferenceImage result;
  result.image = std::move(made.image);
  result.seconds = watch.seconds();
  result.cpu_seconds = own_cpu_seconds() - cpu_start;
  result.noise = made.noise;
  result.ray_rates = rates_of(made.rays);
  return result;
}

int path_tracer_bounces(const ParamValues& params) {
  return path_tracer_options(params).bounces;
}

}  // namespace

ReferenceKind path_tracer_reference() {
  static const std::vector<ParamSpec> params = path_tracer_params(PathTracedUse::reference);
  static const std::vector<ParamPreset> presets = path_tracer_presets();
  return {.name = "path_tracer",
          .doc = "lightbench's own path tracer: a second truth, independent of POV-Ray",
          .params = params,
          .presets = presets,
          .default_preset = "two_bounces",
          .bounces = path_tracer_bounces,
          .tool_version = path_tracer_version,
          .run_scene = run_path_tracer};
}

}  // namespace lightbench
