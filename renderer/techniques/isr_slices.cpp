#include "renderer/techniques/isr_slices.h"

#include "renderer/frame_context.h"

namespace lightbench {
namespace {

constexpr unsigned kPatchUnit = 6;  // of techniques/isr/*.glsl
constexpr unsigned kSurfelUnit = 9;
constexpr unsigned kRadianceUnit = 10;

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

/// A texture for both sides of the surfaces of a picture, one above the other.
GlTexture make_sides(int width, int height) {
  return GlTexture(TexelFormat::rgba16f, width, 2 * height);
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
GlTexture make_radiance(FrameContext& frame, const Surroundings& of, const DirectLight& direct,
                        const GlTexture* indirect, int block) {
  const GBuffer& g = of.gbuffer;
  GlTexture radiance = make_sides(g.width, g.height);
  ShaderDefines defines = gbuffer_defines(g);
  if (indirect) defines.emplace_back("WITH_INDIRECT");
  g.bind();
  direct.irradiance.bind(9);
  direct.back_irradiance.bind(10);
  if (indirect) {
    indirect->bind(11);
    of.surfels.bind(12);
  }
  const Program& program = frame.fullscreen_program("techniques/isr/radiance.frag.glsl", defines);
  program.set("block", block);
  frame.draw_fullscreen(Framebuffer({&radiance}), program);
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
  if (params.number("step_exponent") == 2) defines.emplace_back("STEPS_SQUARED");
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
  from.radiance.bind(kRadianceUnit);
  frame.draw_fullscreen(target, program);
}

}  // namespace

Surroundings draw_surroundings(FrameContext& frame, const ParamValues& params) {
  Surroundings result;
  frame.pass("surround", [&] {
    result.gbuffer = draw_surround(frame, surround_options(frame, params));
    result.surfels = make_surfels(frame, result.gbuffer);
  });
  return result;
}

LitPicture lit_picture(const Surroundings& surroundings) {
  return {surroundings.gbuffer, {.irradiance = true, .back_irradiance = true}};
}

void light_surroundings(FrameContext& frame, const ParamValues& params, const DirectLight& direct,
                        int bounces, Surroundings& surroundings) {
  const Effort effort{params.integer("bounce_slices"), params.integer("bounce_steps")};
  frame.pass("bounces", [&] {
    const int block = params.integer("bounce_resolution");
    const GlTexture receivers = make_receivers(frame, surroundings, block);
    receivers.bind(kPatchUnit);
    surroundings.radiance = make_radiance(frame, surroundings, direct, nullptr, block);
    for (int bounce = 1; bounce < bounces; ++bounce) {
      const GlTexture indirect = make_sides(receivers.width(), receivers.height());
      draw_slices(frame, params, surroundings, effort, {"SURFEL_RECEIVERS"}, Framebuffer({&indirect}));
      surroundings.radiance = make_radiance(frame, surroundings, direct, &indirect, block);
    }
  });
}

void gather_slices(FrameContext& frame, const ParamValues& params, const Surroundings& from,
                   const Framebuffer& target) {
  draw_slices(frame, params, from, {params.integer("slices"), params.integer("steps")}, {}, target);
}

}  // namespace lightbench
