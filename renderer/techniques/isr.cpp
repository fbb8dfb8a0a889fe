#include "renderer/techniques/isr.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "renderer/techniques/isr_kernel.h"
#include "renderer/techniques/isr_params.h"
#include "renderer/techniques/isr_samples.h"
#include "renderer/techniques/isr_slices.h"

namespace lightbench {
namespace {

struct BufferRow {
  const char* name;
  const char* doc;
};
/// In the order of the shader's output.
constexpr std::array kShares{
    BufferRow{"occlusion",
              "ambient openness: 1 - min(1, sum of eq. 26), or what the mask says; 1 on the background"},
    BufferRow{"coverage",
              "share of the directions, cosine-weighted, that surfaces cover; visibility bitmask only"},
    BufferRow{"unknown",
              "share of the directions, cosine-weighted, in which nothing was seen; 0 on the background"},
};

std::string bounce_name(int bounce) {
  return fmt::format("bounce_{}", bounce);
}

/// Those that are made while the image is composed.
std::vector<BufferSpec> kept_buffers() {
  std::vector<BufferSpec> buffers{
      {"indirect", "what is added to the direct light, linear RGB; 0 on the background"}};
  for (const BufferRow& row : kShares) buffers.push_back({row.name, row.doc});
  for (int bounce = 1; bounce <= kMaxBounces; ++bounce)
    buffers.push_back({bounce_name(bounce), fmt::format("the part of it that came by {} bounce{}", bounce,
                                                        bounce == 1 ? "" : "s")});
  return buffers;
}

void bind(const CoarseLight& light) {
  light.indirect.bind(kIndirectUnit);
  if (light.cover) light.cover->bind(kCoverUnit);
}

bool wants_occlusion(const FrameContext& frame, const ParamValues& params) {
  return params.number("k_ssao") > 0 || frame.wants("occlusion") || frame.wants("coverage");
}

CoarseScene downsample(const Isr& isr) {
  CoarseScene coarse;
  coarse.patches = isr.coarse_texture(TexelFormat::rgba32f);
  coarse.radiance = isr.coarse_texture(TexelFormat::rgba16f);
  coarse.normals = isr.coarse_texture(TexelFormat::rg16);
  coarse.depths = isr.coarse_texture(TexelFormat::r32f);
  const Framebuffer target({&coarse.patches, &coarse.radiance, &coarse.normals, &coarse.depths});
  const Program& program = isr.program("downsample");
  program.set("block", isr.block());
  program.set("min_view_cosine", isr.number("min_view_cosine"));
  isr.gbuffer.bind();
  (isr.is("source", "diffuse") ? isr.direct.irradiance : isr.direct.lit).bind(kLightUnit);
  isr.frame.draw_fullscreen(target, program);
  return coarse;
}

/// Directions in which nothing was seen take the mean of the others.
void fill_unknown(const Isr& isr, CoarseLight& light) {
  if (!isr.is("visibility", "bitmask") || !isr.is("unknown", "ambient")) return;
  GlTexture filled = isr.coarse_texture(TexelFormat::rgba16f);
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

/// What is kept at full resolution besides the image.
struct KeptPictures {
  GlTexture indirect;  ///< RGBA32F: what is added to the direct light
  GlTexture shares;    ///< RGBA32F: openness, covered, unknown
};

bool keeps_pictures(const FrameContext& frame) {
  const auto names = kept_buffers();
  return std::any_of(names.begin(), names.end(), [&](const BufferSpec& b) { return frame.wants(b.name); });
}

KeptPictures compose(const Isr& isr, const CoarseScene& coarse, const CoarseLight& light) {
  const glm::ivec2 size(isr.gbuffer.width, isr.gbuffer.height);
  const bool keep = keeps_pictures(isr.frame);
  const GlTexture image(TexelFormat::rgba32f, size.x, size.y);
  KeptPictures kept;
  if (keep)
    kept = {GlTexture(TexelFormat::rgba32f, size.x, size.y), GlTexture(TexelFormat::rgba32f, size.x, size.y)};
  const Framebuffer target =
      keep ? Framebuffer({&image, &kept.indirect, &kept.shares}) : Framebuffer({&image});
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
  return kept;
}

Image component(const Image& image, int index) {
  Image result(image.width, image.height, 1);
  for (std::size_t i = 0; i < result.data.size(); ++i)
    result.data[i] = image.data[i * std::size_t(image.channels) + std::size_t(index)];
  return result;
}

void keep_shares(FrameContext& frame, const KeptPictures& kept) {
  if (!keeps_pictures(frame)) return;
  frame.keep_buffer("indirect", kept.indirect, 3);
  const Image shares = read_back(kept.shares, 3);
  for (std::size_t i = 0; i < kShares.size(); ++i)
    frame.keep_buffer(kShares[i].name, component(shares, int(i)));
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

CoarseLight gather(const Isr& isr, const CoarseScene& coarse, const std::optional<Surroundings>& from) {
  CoarseLight light;
  isr.frame.pass("gather",
                 [&] { light = from ? gather_slices(isr, coarse, *from) : gather_samples(isr, coarse); });
  isr.frame.pass("blur", [&] {
    blur(isr, coarse, light);
    fill_unknown(isr, light);
  });
  return light;
}

int bounces_of(const ParamValues& params) {
  return params.text("visibility") == "bitmask" ? params.integer("bounces") : 1;
}

/// With how many bounces the picture is made, the last being the one that counts: where the light of each
/// bounce is asked for, with one more each time.
std::vector<int> shown_bounces(const FrameContext& frame, const ParamValues& params) {
  std::vector<int> all;
  bool wanted = false;
  for (int bounce = 1; bounce <= bounces_of(params); ++bounce) {
    all.push_back(bounce);
    wanted = wanted || frame.wants(bounce_name(bounce));
  }
  return wanted ? all : std::vector<int>{bounces_of(params)};
}

void keep_bounce(FrameContext& frame, int bounce, const KeptPictures& with, const KeptPictures& without) {
  if (!frame.wants(bounce_name(bounce))) return;
  Image light = read_back(with.indirect, 3);
  if (bounce > 1) {
    const Image before = read_back(without.indirect, 3);
    std::transform(light.data.begin(), light.data.end(), before.data.begin(), light.data.begin(),
                   std::minus<>());
  }
  frame.keep_buffer(bounce_name(bounce), light);
}

/// A job that asks for the second layer gets black of a variant that keeps none.
void keep_missing_buffers(FrameContext& frame) {
  for (const auto& buffers : {kept_buffers(), surround_buffers()})
    for (const BufferSpec& buffer : buffers)
      if (!frame.result().buffers.contains(buffer.name))
        frame.keep_buffer(buffer.name, Image(frame.width(), frame.height(), 3));
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
  frame.pass("downsample", [&] { coarse = downsample(isr); });
  KeptPictures kept;
  for (const int bounces : shown_bounces(frame, params)) {
    if (surroundings) light_surroundings(frame, params, lit.surroundings, bounces, *surroundings);
    const CoarseLight light = gather(isr, coarse, surroundings);
    KeptPictures before = std::exchange(kept, compose(isr, coarse, light));
    keep_bounce(frame, bounces, kept, before);
  }
  keep_shares(frame, kept);
  if (surroundings) keep_surround_buffers(frame, *surroundings);
  keep_missing_buffers(frame);
  keep_direct_buffers(frame, gbuffer, lit.frame);
}

std::vector<std::string> unsupported(const Scene&, const ParamValues& params) {
  std::vector<std::string> reasons;
  const int samples = params.integer("samples");
  if (params.text("visibility") == "bitmask") return reasons;
  const bool grid = params.text("pattern") == "grid";
  if (grid && !fills_grid(samples))
    reasons.emplace_back(
        "pattern 'grid' needs 8, 24, 48, 80 or another number of samples that fills a square round a pixel");
  if (params.number("samples_by_depth") == 0) return reasons;
  if (grid) reasons.emplace_back("pattern 'grid' cannot be had with samples by depth");
  if (samples > kMostSamplesByDepth)
    reasons.push_back(
        fmt::format("samples by depth are at most {} in the mean, not {}", kMostSamplesByDepth, samples));
  return reasons;
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
  for (const auto& buffers : {direct_buffers(), kept_buffers(), surround_buffers()})
    technique.buffers.insert(technique.buffers.end(), buffers.begin(), buffers.end());
  technique.shaders = direct_shaders();
  for (const char* pass : {"downsample", "reduce", "gather", "surfels", "receivers", "radiance", "slices",
                           "depth_sum", "layers", "blur", "fill", "light"})
    technique.shaders.push_back(std::string("techniques/isr/") + pass + ".frag.glsl");
  technique.bounces = bounces_of;
  technique.unsupported = unsupported;
  technique.render = render_isr;
  return technique;
}

}  // namespace lightbench
