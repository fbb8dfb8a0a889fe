#include "renderer/techniques/ambient.h"

#include "renderer/frame_context.h"

namespace lightbench {
namespace {

constexpr const char* kShader = "shaders/ambient.frag.glsl";

void render(FrameContext& frame, const ParamValues& params) {
  GBuffer gbuffer;
  frame.pass("g-buffer",
             [&] { gbuffer = draw_gbuffer(frame, frame.camera(), frame.width(), frame.height()); });
  DirectLightOutputs outputs = wanted_outputs(frame);
  outputs.irradiance = true;
  const DirectLight direct = draw_direct_light(frame, gbuffer, shadow_options(params), outputs);
  keep_direct_buffers(frame, gbuffer, direct);
  frame.pass("ambient", [&] {
    const Program& program = frame.fullscreen_program(kShader, gbuffer_defines(gbuffer));
    program.set("ambient", float(params.number("k")) * mean_irradiance(frame, gbuffer, direct.irradiance));
    gbuffer.bind();
    frame.draw_fullscreen(Framebuffer({&direct.lit}, &gbuffer.depth_stencil), program, Blend::add,
                          kObjects);
  });
  frame.set_image(direct.lit);
}

}  // namespace

Technique ambient_technique() {
  Technique technique;
  technique.name = "ambient";
  technique.doc =
      "Direct lighting and a constant ambient light in proportion to the mean direct light in the picture.";
  technique.params = shadow_params();
  technique.params.push_back(number_param(
      "k", 0.5, 0, 10, "ambient irradiance as a share of the mean direct irradiance of the object pixels"));
  technique.presets = {};
  technique.buffers = direct_buffers();
  technique.shaders = direct_shaders();
  technique.shaders.insert(technique.shaders.end(), {kShader, "shaders/irradiance_sum.frag.glsl"});
  technique.bounces = [](const ParamValues&) { return 1; };
  technique.render = render;
  return technique;
}

}  // namespace lightbench
