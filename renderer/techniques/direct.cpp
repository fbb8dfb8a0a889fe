#include "renderer/techniques/direct.h"

#include "renderer/frame_context.h"

namespace lightbench {
namespace {

void render(FrameContext& frame, const ParamValues& params) {
  GBuffer gbuffer;
  frame.pass("g-buffer",
             [&] { gbuffer = draw_gbuffer(frame, frame.camera(), frame.width(), frame.height()); });
  const DirectLight direct = draw_direct_light(frame, gbuffer, shadow_options(params), wanted_outputs(frame));
  frame.set_image(direct.lit);
  keep_direct_buffers(frame, gbuffer, direct);
}

}  // namespace

Technique direct_technique() {
  Technique technique;
  technique.name = "direct";
  technique.doc = "Deferred direct lighting with shadow maps; no indirect light.";
  technique.params = shadow_params();
  technique.presets = {
      {"no_shadows", {{"shadows", std::string("none")}}, "the thesis's display mode without shadows"},
      {"esm", {{"shadows", std::string("esm")}}, "the thesis's display mode with exponential shadow maps"},
      {"pcf", {{"shadows", std::string("pcf")}}, "percentage-closer filtering"},
  };
  technique.buffers = direct_buffers();
  technique.shaders = direct_shaders();
  technique.render = render;
  return technique;
}

}  // namespace lightbench
