#include "renderer/direct_light.h"

#include <cassert>
#include <stdexcept>

#include <fmt/format.h>
#include <glad/gl.h>

#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"
#include "renderer/shadow_map.h"
#include "scene/light_points.h"

namespace lightbench {
namespace {

struct ShadowModeRow {
  ShadowMode mode;
  const char* name;
  const char* define;
};
constexpr std::array kShadowModes{
    ShadowModeRow{ShadowMode::none, "none", "SHADOW_NONE"},
    ShadowModeRow{ShadowMode::hard, "hard", "SHADOW_HARD"},
    ShadowModeRow{ShadowMode::pcf, "pcf", "SHADOW_PCF"},
    ShadowModeRow{ShadowMode::esm, "esm", "SHADOW_ESM"},
};

// Pixels along the edge of the blocks that one invocation sums up.
constexpr int kSummedBlock = 32;

const ShadowModeRow& row(ShadowMode mode) {
  for (const ShadowModeRow& candidate : kShadowModes)
    if (candidate.mode == mode) return candidate;
  throw std::logic_error("a shadow mode without a row in the table");
}

GlTexture cleared(TexelFormat format, const GBuffer& gbuffer, float value) {
  GlTexture texture(format, gbuffer.width, gbuffer.height);
  Framebuffer({&texture}).clear_color(0, value, value, value, 0);
  return texture;
}

GlTexture copy_of(const GlTexture& source) {
  GlTexture copy(source.format(), source.width(), source.height());
  glCopyImageSubData(source.id(), GL_TEXTURE_2D, 0, 0, 0, 0, copy.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                     source.width(), source.height(), 1);
  return copy;
}

// A picture while light after light is added to it.
struct Lighting {
  LitPicture picture;
  DirectLight light;
  Framebuffer target;
};

Framebuffer target_of(const DirectLight& light, const LitPicture& picture) {
  const DirectLightOutputs& outputs = picture.outputs;
  const GlTexture* depth = &picture.gbuffer.depth_stencil;
  if (outputs.back_irradiance)
    return Framebuffer({&light.lit, &light.irradiance, &light.back_irradiance}, depth);
  if (outputs.irradiance && outputs.visibility)
    return Framebuffer({&light.lit, &light.irradiance, &light.visibility}, depth);
  if (outputs.irradiance) return Framebuffer({&light.lit, &light.irradiance}, depth);
  if (outputs.visibility) return Framebuffer({&light.lit, &light.visibility}, depth);
  return Framebuffer({&light.lit}, depth);
}

Lighting start_lighting(const LitPicture& picture) {
  const auto& [gbuffer, outputs] = picture;
  assert(!outputs.back_irradiance || (outputs.irradiance && !outputs.visibility));
  DirectLight light;
  light.lit = copy_of(gbuffer.emission);
  if (outputs.irradiance) light.irradiance = cleared(TexelFormat::rgba32f, gbuffer, 0);
  if (outputs.back_irradiance) light.back_irradiance = cleared(TexelFormat::rgba32f, gbuffer, 0);
  if (outputs.visibility) light.visibility = cleared(TexelFormat::r32f, gbuffer, 1);
  Framebuffer target = target_of(light, picture);
  return {picture, std::move(light), std::move(target)};
}

const Program& light_program(FrameContext& frame, const LitPicture& picture, const Light& light,
                             ShadowMode mode) {
  const auto& [gbuffer, outputs] = picture;
  ShaderDefines defines = gbuffer_defines(gbuffer);
  defines.emplace_back(row(mode).define);
  for (const std::string& define : projection_defines(shadow_projection(light))) defines.push_back(define);
  if (outputs.irradiance) defines.emplace_back("WITH_IRRADIANCE");
  if (outputs.back_irradiance) defines.emplace_back("WITH_BACK");
  if (outputs.visibility) {
    defines.emplace_back("WITH_VISIBILITY");
    defines.emplace_back(fmt::format("VISIBILITY_LOCATION {}", outputs.irradiance ? 2 : 1));
  }
  return frame.fullscreen_program("shaders/direct.frag.glsl", defines);
}

void light_picture(FrameContext& frame, const Lighting& lighting, const Light& light,
                   const ShadowOptions& shadows) {
  lighting.picture.gbuffer.bind();
  const Program& program = light_program(frame, lighting.picture, light, shadows.mode);
  program.set("shadow_bias", shadows.bias);
  program.set("esm_sharpness", shadows.esm_sharpness);
  program.set("pcf_radius", shadows.pcf_radius);
  frame.draw_fullscreen(lighting.target, program, Blend::add, kObjects);
}

// Adds a light without extent, which makes that share of the mean visibility.
void add_light(FrameContext& frame, std::span<const LitPicture> pictures,
               const std::vector<Lighting>& lightings, const Light& light, float share,
               const ShadowOptions& shadows) {
  LightBlock block = light_block(light, share);
  if (shadows.mode != ShadowMode::none)
    frame.pass("shadow map", [&] {
      draw_shadow_map(frame, pictures, light, shadows, frame.shadow_textures(), block).bind(8);
    });
  frame.pass("direct", [&] {
    const Buffer buffer(&block, sizeof block);
    buffer.bind_uniform(1);
    for (const Lighting& lighting : lightings) light_picture(frame, lighting, light, shadows);
  });
}

}  // namespace

std::vector<ParamSpec> shadow_params() {
  const ShadowOptions defaults;
  std::vector<std::string> modes;
  for (const ShadowModeRow& mode : kShadowModes) modes.emplace_back(mode.name);
  return {
      choice_param("shadows", std::move(modes), row(defaults.mode).name,
                   "how shadows of direct light are made: not at all, hard, with percentage-closer "
                   "filtering, or with exponential shadow maps"),
      integer_param("shadow_size", defaults.point_size, 16, 16384,
                    "texels along an edge of a point or spot light's shadow map (hard, pcf)"),
      integer_param("directional_shadow_size", defaults.directional_size, 16, 16384,
                    "texels along an edge of each slice of a directional light's shadow map (hard, pcf)"),
      integer_param(
          "directional_slices", defaults.slices, 1, kMaxShadowViews,
          "slices of the camera's depths that each get a directional shadow map of their own (hard, pcf)"),
      number_param("shadow_bias", defaults.bias, 0, 100,
                   "how much nearer to the light an occluder has to be than the receiver's plane, in texels "
                   "(hard, pcf)"),
      integer_param("pcf_radius", defaults.pcf_radius, 0, 16,
                    "texels to each side that percentage-closer filtering compares with"),
      integer_param("esm_size", defaults.esm_size, 16, 16384,
                    "texels along an edge of a point or spot light's exponential shadow map"),
      integer_param("directional_esm_size", defaults.directional_esm_size, 16, 16384,
                    "texels along an edge of a directional light's exponential shadow map"),
      number_param("esm_sharpness", defaults.esm_sharpness, 1, 1000,
                   "constant c of exponential shadow maps: visibility exp(-c (r - o))"),
      integer_param("esm_blur_radius", defaults.esm_blur_radius, 0, 32,
                    "texels to each side of the Gaussian that blurs exponential shadow maps"),
  };
}

ShadowOptions shadow_options(const ParamValues& params) {
  ShadowOptions options;
  for (const ShadowModeRow& mode : kShadowModes)
    if (params.text("shadows") == mode.name) options.mode = mode.mode;
  options.point_size = params.integer("shadow_size");
  options.directional_size = params.integer("directional_shadow_size");
  options.slices = params.integer("directional_slices");
  options.bias = float(params.number("shadow_bias"));
  options.pcf_radius = params.integer("pcf_radius");
  options.esm_size = params.integer("esm_size");
  options.directional_esm_size = params.integer("directional_esm_size");
  options.esm_sharpness = float(params.number("esm_sharpness"));
  options.esm_blur_radius = params.integer("esm_blur_radius");
  return options;
}

std::vector<DirectLight> draw_direct_light(FrameContext& frame, std::span<const LitPicture> pictures,
                                           const ShadowOptions& shadows) {
  std::vector<Lighting> lightings;
  for (const LitPicture& picture : pictures) lightings.push_back(start_lighting(picture));
  const std::vector<Light>& lights = frame.scene().lights;
  for (const Light& light : lights) {
    const std::vector<Light> points = light_points(light);
    const float share = 1.0f / float(lights.size() * points.size());
    for (const Light& point : points) add_light(frame, pictures, lightings, point, share, shadows);
  }
  std::vector<DirectLight> results;
  for (Lighting& lighting : lightings) results.push_back(std::move(lighting.light));
  return results;
}

DirectLight draw_direct_light(FrameContext& frame, const GBuffer& gbuffer, const ShadowOptions& shadows,
                              const DirectLightOutputs& outputs) {
  const LitPicture picture{gbuffer, outputs};
  return std::move(draw_direct_light(frame, {&picture, 1}, shadows).front());
}

glm::vec3 mean_irradiance(FrameContext& frame, const GBuffer& gbuffer, const GlTexture& irradiance) {
  const auto blocks_along = [](int pixels) { return (pixels + kSummedBlock - 1) / kSummedBlock; };
  const GlTexture blocks(TexelFormat::rgba32f, blocks_along(gbuffer.width), blocks_along(gbuffer.height));
  const Program& program = frame.fullscreen_program("shaders/irradiance_sum.frag.glsl");
  program.set("block_size", kSummedBlock);
  gbuffer.bind();
  irradiance.bind(8);
  frame.draw_fullscreen(Framebuffer({&blocks}), program);
  glm::dvec4 sum(0.0);
  const Image sums = read_back(blocks, 4);
  for (std::size_t i = 0; i < sums.data.size(); i += 4)
    sum += glm::dvec4(sums.data[i], sums.data[i + 1], sums.data[i + 2], sums.data[i + 3]);
  return sum.w == 0 ? glm::vec3(0) : glm::vec3(glm::dvec3(sum) / sum.w);
}

}  // namespace lightbench
