#include "renderer/techniques/isr.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>

#include <glm/gtc/constants.hpp>
#include <glm/vec4.hpp>

#include "renderer/direct_light.h"
#include "renderer/frame_context.h"
#include "renderer/techniques/isr_kernel.h"
#include "renderer/techniques/isr_params.h"
#include "renderer/techniques/isr_slices.h"

namespace lightbench {
namespace {

constexpr unsigned kPatchUnit = 6;  // of techniques/isr/*.glsl
constexpr unsigned kRadianceUnit = 7;
constexpr unsigned kNormalUnit = 8;
constexpr unsigned kDepthUnit = 8;
constexpr unsigned kIndirectUnit = 9;
constexpr unsigned kLightUnit = 9;
constexpr unsigned kOpennessUnit = 10;
constexpr unsigned kLitUnit = 11;
constexpr unsigned kFarPatchUnit = 9;
constexpr unsigned kFarRadianceUnit = 10;
constexpr unsigned kKernelBinding = 1;

/// What is gathered from: techniques/isr/coarse.glsl.
struct CoarseScene {
  GlTexture patches;
  GlTexture radiance;
  GlTexture normals;
  GlTexture depths;
  GlTexture far_patches;  ///< in larger blocks; empty where far_block is 1
  GlTexture far_radiance;
};

/// What is gathered.
struct CoarseLight {
  GlTexture indirect;
  std::optional<GlTexture> openness;  ///< only where it is asked for
};

/// One frame's inputs, common to all passes.
struct Isr {
  FrameContext& frame;
  const ParamValues& params;
  const GBuffer& gbuffer;
  const DirectLight& direct;
  ShaderDefines defines;
  glm::ivec2 coarse_size;
  bool occlusion;

  float number(const char* name) const { return float(params.number(name)); }
  bool is(const char* name, const char* choice) const { return params.text(name) == choice; }
  int block() const { return params.integer("resolution"); }
  /// Eq. 25 knows no other patch than the pixel.
  int far_block() const { return is("weighting", "paper") ? 1 : params.integer("far_block"); }
  const Program& program(const std::string& name, const ShaderDefines& more = {}) const {
    ShaderDefines all = defines;
    all.insert(all.end(), more.begin(), more.end());
    return frame.fullscreen_program("techniques/isr/" + name + ".frag.glsl", all);
  }
};

bool wants_occlusion(const FrameContext& frame, const ParamValues& params) {
  return params.number("k_ssao") > 0 || frame.wants("occlusion");
}

/// Whether the background is gathered: black is not worth the work.
bool gathers_background(const Isr& isr) {
  const Background& background = isr.frame.scene().background;
  return isr.params.boolean("background") && background.lights && background.color != glm::vec3(0);
}

GlTexture coarse_texture(const Isr& isr, TexelFormat format) {
  return GlTexture(format, isr.coarse_size.x, isr.coarse_size.y);
}

CoarseLight make_light(const Isr& isr) {
  CoarseLight light{coarse_texture(isr, TexelFormat::rgba16f), std::nullopt};
  if (isr.occlusion) light.openness = coarse_texture(isr, TexelFormat::r16f);
  return light;
}

Framebuffer target_of(const CoarseLight& light) {
  if (light.openness) return Framebuffer({&light.indirect, &*light.openness});
  return Framebuffer({&light.indirect});
}

void bind(const CoarseLight& light) {
  light.indirect.bind(kIndirectUnit);
  if (light.openness) light.openness->bind(kOpennessUnit);
}

CoarseScene downsample(const Isr& isr) {
  CoarseScene coarse;
  coarse.patches = coarse_texture(isr, TexelFormat::rgba32f);
  coarse.radiance = coarse_texture(isr, TexelFormat::rgba16f);
  coarse.normals = coarse_texture(isr, TexelFormat::rg16);
  coarse.depths = coarse_texture(isr, TexelFormat::r32f);
  const Framebuffer target({&coarse.patches, &coarse.radiance, &coarse.normals, &coarse.depths});
  const Program& program = isr.program("downsample");
  program.set("block", isr.block());
  program.set("min_view_cosine", isr.number("min_view_cosine"));
  isr.gbuffer.bind();
  (isr.is("source", "diffuse") ? isr.direct.irradiance : isr.direct.lit).bind(kLightUnit);
  isr.frame.draw_fullscreen(target, program);
  return coarse;
}

void reduce(const Isr& isr, CoarseScene& coarse) {
  const int block = isr.far_block();
  if (block == 1) return;
  const glm::ivec2 size = (isr.coarse_size + block - 1) / block;
  coarse.far_patches = GlTexture(TexelFormat::rgba32f, size.x, size.y);
  coarse.far_radiance = GlTexture(TexelFormat::rgba16f, size.x, size.y);
  const Framebuffer target({&coarse.far_patches, &coarse.far_radiance});
  const Program& program = isr.program("reduce");
  program.set("block", block);
  coarse.patches.bind(kPatchUnit);
  coarse.radiance.bind(kRadianceUnit);
  isr.frame.draw_fullscreen(target, program);
}

std::vector<KernelSample> make_kernel(const Isr& isr) {
  const int samples = isr.params.integer("samples");
  if (isr.is("pattern", "grid")) return grid_kernel(samples, isr.number("spacing"));
  return spiral_kernel(samples, isr.number("radius") * float(isr.coarse_size.x), isr.number("spread"));
}

/// The kernel as the shader has it: shares on the image plane at distance 1, divided by pi.
Buffer kernel_block(const Isr& isr, const std::vector<KernelSample>& kernel, float pixel_size) {
  std::vector<glm::vec4> block(kMaxKernelSamples, glm::vec4(0));
  const bool paper = isr.is("weighting", "paper");
  for (std::size_t i = 0; i < kernel.size(); ++i) {
    const float area = paper ? 1.0f : kernel[i].area;  // eq. 25 takes one pixel as the patch
    block[i] = glm::vec4(kernel[i].offset, area * pixel_size * pixel_size / glm::pi<float>(), 0);
  }
  return Buffer(block.data(), block.size() * sizeof block[0]);
}

ShaderDefines gather_defines(const Isr& isr) {
  ShaderDefines defines;
  if (gathers_background(isr)) defines.push_back("BACKGROUND");
  const int block = isr.far_block();
  if (block > 1) defines.push_back("FAR_BLOCK " + std::to_string(block));
  return defines;
}

CoarseLight gather(const Isr& isr, const CoarseScene& coarse) {
  // Edge of a coarse pixel at distance 1.
  const float pixel_size = 2 * isr.gbuffer.camera.tan_half_y * float(isr.block()) / float(isr.gbuffer.height);
  const std::vector<KernelSample> kernel = make_kernel(isr);
  const Buffer block = kernel_block(isr, kernel, pixel_size);
  CoarseLight light = make_light(isr);
  const Program& program = isr.program("gather", gather_defines(isr));
  program.set("near_count", near_samples(kernel, isr.far_block()));
  program.set("sample_count", int(kernel.size()));
  program.set("coarse_texel", float(isr.block()) / glm::vec2(isr.gbuffer.width, isr.gbuffer.height));
  program.set("form_factor_limit", isr.number("form_factor_limit"));
  program.set("background", isr.frame.scene().background.color);
  program.set("occluder_radius", isr.number("occluder_radius") * pixel_size / float(isr.block()));
  program.set("occlusion_scale",
              isr.number("occlusion_radius") * float(isr.coarse_size.x) / kernel_reach(kernel));
  isr.gbuffer.camera_block.bind_uniform(0);
  block.bind_uniform(kKernelBinding);
  coarse.patches.bind(kPatchUnit);
  coarse.radiance.bind(kRadianceUnit);
  coarse.normals.bind(kNormalUnit);
  if (coarse.far_patches.id() != 0) {
    coarse.far_patches.bind(kFarPatchUnit);
    coarse.far_radiance.bind(kFarRadianceUnit);
  }
  isr.frame.draw_fullscreen(target_of(light), program);
  return light;
}

CoarseLight gather_with_visibility(const Isr& isr, const CoarseScene& coarse,
                                   const Surroundings& surroundings) {
  CoarseLight light = make_light(isr);
  // Visibility is in the light itself: there is no ambient occlusion beside it.
  if (light.openness) Framebuffer({&*light.openness}).clear_color(0, 1, 1, 1, 1);
  coarse.patches.bind(kPatchUnit);
  coarse.normals.bind(kNormalUnit);
  gather_slices(isr.frame, isr.params, surroundings, Framebuffer({&light.indirect}));
  return light;
}

/// Directions in which nothing was seen take the mean of the others.
void fill_unknown(const Isr& isr, CoarseLight& light) {
  if (!isr.is("visibility", "bitmask") || !isr.is("unknown", "ambient")) return;
  GlTexture filled = coarse_texture(isr, TexelFormat::rgba16f);
  light.indirect.bind(kIndirectUnit);
  isr.frame.draw_fullscreen(Framebuffer({&filled}), isr.program("fill"));
  light.indirect = std::move(filled);
}

void blur_along(const Isr& isr, const CoarseLight& from, const CoarseLight& to, const glm::ivec2& direction) {
  const int radius = isr.params.integer("blur_radius");
  const float sigma = 0.5f * float(radius) + 0.5f;
  const Program& program = isr.program("blur");
  program.set("direction", direction);
  program.set("radius", radius);
  program.set("coarse_size", isr.coarse_size);
  program.set("falloff", 1 / (2 * sigma * sigma));
  program.set("plane_tolerance", isr.number("blur_plane"));
  bind(from);
  isr.frame.draw_fullscreen(target_of(to), program);
}

void blur(const Isr& isr, const CoarseScene& coarse, CoarseLight& light) {
  if (isr.is("blur", "none")) return;
  const CoarseLight between = make_light(isr);
  isr.gbuffer.camera_block.bind_uniform(0);
  coarse.patches.bind(kPatchUnit);
  blur_along(isr, light, between, {1, 0});
  blur_along(isr, between, light, {0, 1});
}

/// The image, and the named buffers at full resolution.
void compose(const Isr& isr, const CoarseScene& coarse, const CoarseLight& light) {
  const glm::ivec2 size(isr.gbuffer.width, isr.gbuffer.height);
  const bool keep = isr.frame.wants("indirect") || isr.frame.wants("occlusion");
  const GlTexture image(TexelFormat::rgba32f, size.x, size.y);
  std::optional<GlTexture> indirect;
  std::optional<GlTexture> openness;
  if (keep) {
    indirect.emplace(TexelFormat::rgba32f, size.x, size.y);
    openness.emplace(TexelFormat::r32f, size.x, size.y);
  }
  const Framebuffer target = keep ? Framebuffer({&image, &*indirect, &*openness}) : Framebuffer({&image});
  isr.frame.pass("upsample and light", [&] {
    const Program& program = isr.program("light", keep ? ShaderDefines{"KEEP_BUFFERS"} : ShaderDefines{});
    program.set("block", isr.block());
    program.set("coarse_size", isr.coarse_size);
    program.set("depth_epsilon", isr.number("upsample_epsilon"));
    program.set("depth_tolerance", isr.number("upsample_tolerance"));
    program.set("k_isr", isr.number("k_isr"));
    program.set("k_ssao", isr.number("k_ssao"));
    isr.gbuffer.bind();
    coarse.depths.bind(kDepthUnit);
    bind(light);
    isr.direct.lit.bind(kLitUnit);
    isr.frame.draw_fullscreen(target, program);
  });
  isr.frame.set_image(image);
  if (!keep) return;
  isr.frame.keep_buffer("indirect", *indirect, 3);
  isr.frame.keep_buffer("occlusion", *openness, 1);
}

ShaderDefines all_defines(const GBuffer& gbuffer, const ParamValues& params, bool occlusion) {
  ShaderDefines defines = gbuffer_defines(gbuffer);
  for (std::string& define : isr_defines(params)) defines.push_back(std::move(define));
  if (occlusion) defines.push_back("OCCLUSION");
  if (!params.boolean("direct")) defines.push_back("INDIRECT_ONLY");
  return defines;
}

/// Direct light of the frame and, where there are any, of its surroundings.
struct Lit {
  DirectLight frame;
  DirectLight surroundings;
};

Lit light_all(FrameContext& frame, const ParamValues& params, const GBuffer& gbuffer,
              const std::optional<Surroundings>& surroundings) {
  DirectLightOutputs outputs = wanted_outputs(frame);
  outputs.irradiance = outputs.irradiance || params.text("source") == "diffuse";
  std::vector<LitPicture> pictures{{gbuffer, outputs}};
  if (surroundings) pictures.push_back(lit_picture(*surroundings));
  const ShadowOptions shadows = shadow_options(params);
  const std::size_t together = params.boolean("shared_shadows") ? pictures.size() : 1;
  std::vector<DirectLight> lights;
  for (std::size_t i = 0; i < pictures.size(); i += together)
    for (DirectLight& light : draw_direct_light(frame, std::span(pictures).subspan(i, together), shadows))
      lights.push_back(std::move(light));
  Lit lit{std::move(lights.front()), {}};
  if (surroundings) lit.surroundings = std::move(lights.back());
  return lit;
}

void render_isr(FrameContext& frame, const ParamValues& params) {
  GBuffer gbuffer;
  frame.pass("g-buffer", [&] {
    GBufferOptions options;
    if (params.text("normals") == "rgb8") options.normals = NormalFormat::rgb8;
    gbuffer = draw_gbuffer(frame, frame.camera(), frame.width(), frame.height(), options);
  });
  std::optional<Surroundings> surroundings;
  if (params.text("visibility") == "bitmask") surroundings = draw_surroundings(frame, params);
  const Lit lit = light_all(frame, params, gbuffer, surroundings);

  const int block = params.integer("resolution");
  const glm::ivec2 coarse_size((gbuffer.width + block - 1) / block, (gbuffer.height + block - 1) / block);
  const bool occlusion = wants_occlusion(frame, params);
  const Isr isr{frame,       params,   gbuffer, lit.frame, all_defines(gbuffer, params, occlusion),
                coarse_size, occlusion};
  CoarseScene coarse;
  CoarseLight light;
  frame.pass("downsample", [&] {
    coarse = downsample(isr);
    reduce(isr, coarse);
  });
  if (surroundings) {
    light_surroundings(frame, params, lit.surroundings, params.integer("bounces"), *surroundings);
    frame.pass("gather", [&] { light = gather_with_visibility(isr, coarse, *surroundings); });
  } else {
    frame.pass("gather", [&] { light = gather(isr, coarse); });
  }
  frame.pass("blur", [&] {
    blur(isr, coarse, light);
    fill_unknown(isr, light);
  });
  compose(isr, coarse, light);
  keep_direct_buffers(frame, gbuffer, lit.frame);
}

std::vector<std::string> unsupported(const Scene&, const ParamValues& params) {
  if (params.text("pattern") == "grid" && !fills_grid(params.integer("samples")))
    return {
        "pattern 'grid' needs 8, 24, 48, 80 or another number of samples that fills a square round a pixel"};
  return {};
}

}  // namespace

Technique isr_technique() {
  Technique technique;
  technique.name = "isr";
  technique.doc =
      "direct lighting and indirect light gathered from what the camera sees, or all around it (image-space "
      "radiosity)";
  technique.params = isr_params();
  technique.presets = isr_presets();
  technique.buffers = direct_buffers();
  technique.buffers.push_back(
      {"indirect", "what is added to the direct light, linear RGB; 0 on the background"});
  technique.buffers.push_back(
      {"occlusion", "ambient openness, 1 - min(1, sum of eq. 26); 1 on the background"});
  technique.shaders = direct_shaders();
  for (const char* pass : {"downsample", "reduce", "gather", "surfels", "receivers", "radiance", "slices",
                           "blur", "fill", "light"})
    technique.shaders.push_back(std::string("techniques/isr/") + pass + ".frag.glsl");
  technique.bounces = [](const ParamValues& params) {
    return params.text("visibility") == "bitmask" ? params.integer("bounces") : 1;
  };
  technique.unsupported = unsupported;
  technique.render = render_isr;
  return technique;
}

}  // namespace lightbench
