#include "renderer/techniques/path_tracer.h"

#include <fmt/format.h>

#include "renderer/frame_context.h"
#include "renderer/path_tracer.h"

namespace lightbench {
namespace {

void render(FrameContext& frame, const ParamValues& params) {
  const FrameRequest& request = frame.request();
  const PathTracerOptions options = path_tracer_options(params);
  PathTracedImage traced =
      trace_paths(request.scene, request.view, request.width, request.height, request.samples, options);
  for (const RayRate& rate : traced.rays) frame.add_pass_time(rate.name + " rays", rate.seconds);
  if (options.noise > 0 && traced.noise > options.noise)
    frame.warn(
        fmt::format("the path-traced picture has an estimated error of {:.2f} of 255 after all {} samples",
                    traced.noise, options.samples));
  frame.set_image(std::move(traced.image));
}

int bounces(const ParamValues& params) {
  return path_tracer_options(params).bounces;
}

}  // namespace

Technique path_tracer_technique() {
  Technique technique;
  technique.name = "path_tracer";
  technique.doc = "the built-in path tracer: direct light and diffuse bounces, without OpenGL";
  technique.params = path_tracer_params(PathTracedUse::variant);
  technique.presets = path_tracer_presets();
  technique.bounces = bounces;
  technique.version = kPathTracerVersion;
  technique.needs_gl = false;
  technique.offline = true;
  technique.render = render;
  return technique;
}

}  // namespace lightbench
