#include "renderer/techniques/isr_slices.h"

#include "renderer/frame_context.h"

namespace lightbench {
namespace {

constexpr unsigned kPatchUnit = 6;  // of techniques/isr/*.glsl
constexpr unsigned kSurfelUnit = 9;
constexpr unsigned kFrontUnit = 10;
constexpr unsigned kBackUnit = 11;

SurroundOptions surround_options(const FrameContext& frame, const ParamValues& params) {
  SurroundOptions options;
  options.layers = params.integer("layers");
  options.front_faces = params.text("layer_faces") == "front";
  const bool cube = params.text("cameras") == "cube";
  if (cube) options.cube_size = params.integer("camera_size");
  options.wide_factor = float(params.number("guard"));
  const float share = options.wide_factor / float(params.integer("guard_resolution"));
  options.wide_size = glm::max(glm::ivec2(share * glm::vec2(frame.width(), frame.height())), glm::ivec2(1));
  return options;
}

/// Both sides' textures of an image of the surround's size.
struct Sides {
  GlTexture front;
  GlTexture back;
};

Sides make_sides(int width, int height) {
  return {GlTexture(TexelFormat::rgba16f, width, height), GlTexture(TexelFormat::rgba16f, width, height)};
}

GlTexture make_surfels(FrameContext& frame, const GBuffer& g) {
  GlTexture surfels(TexelFormat::rgba32f, g.width, g.height);
  g.bind();
  frame.draw_fullscreen(Framebuffer({&surfels}),
                        frame.fullscreen_program("techniques/isr/surfels.frag.glsl", gbuffer_defines(g)));
  return surfels;
}

/// Where light is gathered for blocks of texels.
GlTexture make_receivers(FrameContext& frame, const Surroundings& of, int block) {
  const auto blocks_along = [&](int texels) { return (texels + block - 1) / block; };
  GlTexture receivers(TexelFormat::rgba32f, blocks_along(of.gbuffer.width), blocks_along(of.gbuffer.height));
  const Program& program = frame.fullscreen_program("techniques/isr/receivers.frag.glsl");
  program.set("block", block);
  of.gbuffer.bind();
  of.surfels.bind(kSurfelUnit);
  frame.draw_fullscreen(Framebuffer({&receivers}), program);
  return receivers;
}

/// `indirect` is of blocks of texels, whose receivers are bound as patches.
Sides make_radiance(FrameContext& frame, const Surroundings& of, const DirectLight& direct,
                    const Sides* indirect, int block) {
  const GBuffer& g = of.gbuffer;
  Sides radiance = make_sides(g.width, g.height);
  ShaderDefines defines = gbuffer_defines(g);
  if (indirect) defines.emplace_back("WITH_INDIRECT");
  g.bind();
  direct.irradiance.bind(9);
  direct.back_irradiance.bind(10);
  if (indirect) {
    indirect->front.bind(11);
    indirect->back.bind(12);
    of.surfels.bind(13);
  }
  const Program& program = frame.fullscreen_program("techniques/isr/radiance.frag.glsl", defines);
  program.set("block", block);
  frame.draw_fullscreen(Framebuffer({&radiance.front, &radiance.back}), program);
  return radiance;
}

/// How finely one gathering looks.
struct Effort {
  int slices;
  int steps;
};

void draw_slices(FrameContext& frame, const ParamValues& params, const Surroundings& from,
                 const Effort& effort, ShaderDefines defines, const Framebuffer& target) {
  const float thickness = float(params.number("thickness"));
  if (thickness > 0) defines.emplace_back("THICKNESS");
  if (params.text("unknown") == "ambient") defines.emplace_back("UNKNOWN_AMBIENT");
  const Program& program = frame.fullscreen_program("techniques/isr/slices.frag.glsl", defines);
  program.set("slices", effort.slices);
  program.set("steps", effort.steps);
  program.set("step_exponent", float(params.number("step_exponent")));
  program.set("thickness", thickness);
  const Background& background = frame.scene().background;
  program.set("background",
              background.lights && params.boolean("background") ? background.color : glm::vec3(0));
  from.gbuffer.camera_block.bind_uniform(0);
  from.gbuffer.tile_block.bind_uniform(2);
  from.surfels.bind(kSurfelUnit);
  from.front_radiance.bind(kFrontUnit);
  from.back_radiance.bind(kBackUnit);
  frame.draw_fullscreen(target, program);
}

}  // namespace

Surroundings draw_surroundings(FrameContext& frame, const ParamValues& params) {
  Surroundings result;
  frame.pass("surround", [&] {
    result.gbuffer = draw_surround(frame, surround_options(frame, params));
    result.surfels = make_surfels(frame, result.gbuffer);
  });
  DirectLightOutputs outputs;
  outputs.irradiance = true;
  outputs.back_irradiance = true;
  const DirectLight direct = draw_direct_light(frame, result.gbuffer, shadow_options(params), outputs);
  const Effort effort{params.integer("bounce_slices"), params.integer("bounce_steps")};
  frame.pass("bounces", [&] {
    const int block = params.integer("bounce_resolution");
    const GlTexture receivers = make_receivers(frame, result, block);
    receivers.bind(kPatchUnit);
    Sides radiance = make_radiance(frame, result, direct, nullptr, block);
    for (int bounce = 1;; ++bounce) {
      result.front_radiance = std::move(radiance.front);
      result.back_radiance = std::move(radiance.back);
      if (bounce == params.integer("bounces")) break;
      const Sides indirect = make_sides(receivers.width(), receivers.height());
      draw_slices(frame, params, result, effort, {"SURFEL_RECEIVERS"},
                  Framebuffer({&indirect.front, &indirect.back}));
      radiance = make_radiance(frame, result, direct, &indirect, block);
    }
  });
  return result;
}

void gather_slices(FrameContext& frame, const ParamValues& params, const Surroundings& from,
                   const Framebuffer& target) {
  draw_slices(frame, params, from, {params.integer("slices"), params.integer("steps")}, {}, target);
}

}  // namespace lightbench
