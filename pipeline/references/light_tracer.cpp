#include "pipeline/references/light_tracer.h"

#include "base/process.h"
#include "base/stopwatch.h"
#include "renderer/caustics/light_traced_image.h"

namespace lightbench {
namespace {

ReferenceImage run_light_tracer(const ReferenceRequest& request, const Scene& scene) {
  const Stopwatch watch;
  const double cpu_start = own_cpu_seconds();
  LightTracedImage made = light_traced_image(scene, request.view, request.width, request.height,
                                             request.samples, light_tracer_options(request.params));
  ReferenceImage result;
  result.image = std::move(made.image);
  result.seconds = watch.seconds();
  result.cpu_seconds = own_cpu_seconds() - cpu_start;
  result.noise = made.noise;
  return result;
}

}  // namespace

ReferenceKind light_tracer_reference() {
  static const std::vector<ParamSpec> params = light_tracer_params();
  static const std::vector<ParamPreset> presets{{"converged", {{"rays", 40'000'000LL}}, "the defaults"}};
  return {.name = "light_tracer",
          .doc = "rays from the lights through the scene's water, for technique caustics",
          .params = params,
          .presets = presets,
          .default_preset = "converged",
          .bounces = [](const ParamValues&) { return 0; },
          .tool_version = light_tracer_version,
          .run_scene = run_light_tracer};
}

}  // namespace lightbench
