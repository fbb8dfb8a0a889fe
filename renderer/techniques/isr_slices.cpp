#include "renderer/techniques/isr_slices.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/frame_context.h"
#include "renderer/techniques/isr_samples.h"

namespace lightbench {
namespace {

constexpr unsigned kSurfelUnit = 9;  // of techniques/isr/slices.frag.glsl
constexpr unsigned kRadianceUnit = 10;
constexpr int kKeptLayers = 4;  // that have a named buffer

std::string layer_name(int layer) {
  return fmt::format("layer_{}", layer);
}

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

/// The program with all that both kinds of receivers need.
const Program& slices_program(FrameContext& frame, const ParamValues& params, const Surroundings& from,
                              const Effort& effort, ShaderDefines defines) {
  const float thickness = float(params.number("thickness"));
  if (thickness > 0) defines.emplace_back("THICKNESS");
  if (params.text("unknown") == "ambient") defines.emplace_back("UNKNOWN_AMBIENT");
  if (params.text("layer_faces") == "all") defines.emplace_back("ALL_FACES");
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
  return program;
}

}  // namespace

Surroundings draw_surroundings(FrameContext& frame, const ParamValues& params) {
  Surroundings result;
  frame.pass("surround", [&] {
    const SurroundOptions options = surround_options(frame, params);
    result.layers = options.layers;
    result.gbuffer = draw_surround(frame, options);
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
      frame.draw_fullscreen(Framebuffer({&indirect}),
                            slices_program(frame, params, surroundings, effort, {"SURFEL_RECEIVERS"}));
      surroundings.radiance = make_radiance(frame, surroundings, direct, &indirect, block);
    }
  });
}

CoarseLight gather_slices(const Isr& isr, const CoarseScene& coarse, const Surroundings& from) {
  CoarseLight light = make_light(isr);
  const Effort effort{isr.params.integer("slices"), isr.params.integer("steps")};
  ShaderDefines defines;
  if (isr.occlusion) defines.emplace_back("OCCLUSION");
  const bool by_depth = isr.number("samples_by_depth") > 0;
  const float scale = by_depth ? samples_scale(isr, coarse) : 1;
  if (by_depth) defines.emplace_back("SAMPLES_BY_DEPTH");
  const Program& program = slices_program(isr.frame, isr.params, from, effort, defines);
  program.set("depth_exponent", isr.number("samples_by_depth"));
  program.set("depth_scale", scale);
  program.set("occlusion_reach", isr.number("occlusion_radius") * 2 * isr.gbuffer.camera.tan_half_x);
  coarse.patches.bind(kPatchUnit);
  coarse.normals.bind(kCoarseNormalUnit);
  isr.frame.draw_fullscreen(target_of(light), program);
  return light;
}

std::vector<BufferSpec> surround_buffers() {
  std::vector<BufferSpec> buffers{
      {"surround",
       "what is gathered from, all around the camera: longitude across, latitude along, the view "
       "in the middle; linear RGB, 0 where no picture reaches; visibility bitmask only"}};
  for (int layer = 2; layer <= kKeptLayers; ++layer)
    buffers.push_back({layer_name(layer), fmt::format("what the surface number {} along each pixel's ray "
                                                      "sends to the camera; linear RGB, 0 where none is kept",
                                                      layer)});
  return buffers;
}

void keep_surround_buffers(FrameContext& frame, const Surroundings& surroundings) {
  const auto keep = [&](const std::string& name, int layer, const ShaderDefines& defines) {
    if (!frame.wants(name)) return;
    const GlTexture picture(TexelFormat::rgba32f, frame.width(), frame.height());
    const Program& program = frame.fullscreen_program("techniques/isr/layers.frag.glsl", defines);
    program.set("layer", layer - 1);
    surroundings.gbuffer.camera_block.bind_uniform(0);
    surroundings.gbuffer.tile_block.bind_uniform(2);
    surroundings.radiance.bind(kRadianceUnit);
    frame.draw_fullscreen(Framebuffer({&picture}), program);
    frame.keep_buffer(name, picture, 3);
  };
  keep("surround", 1, {"PANORAMA"});
  const int layers = surroundings.layers;
  for (int layer = 2; layer <= std::min(layers, kKeptLayers); ++layer) keep(layer_name(layer), layer, {});
}

}  // namespace lightbench
