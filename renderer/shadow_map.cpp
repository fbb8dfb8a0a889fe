#include "renderer/shadow_map.h"

#include <algorithm>
#include <cmath>

#include <glad/gl.h>

#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"

namespace lightbench {
namespace {

// Pixels along the edge of the blocks that are measured by one invocation.
constexpr int kMeasuredBlock = 32;

// What the camera sees by a light's views.
struct Seen {
  std::array<ViewExtent, kMaxShadowViews> views;
  float nearest = 1e30f;  // along an orthographic view, else the distance from the light
  float farthest = -1e30f;
};

int blocks_along(int pixels) {
  return (pixels + kMeasuredBlock - 1) / kMeasuredBlock;
}

// How many views a light's map has.
int view_count(ShadowProjection projection, const ShadowOptions& options) {
  if (projection == ShadowProjection::cube) return 6;
  // An exponential map's blur is wide: slices would show where its width changes.
  return projection == ShadowProjection::orthographic && options.mode != ShadowMode::esm ? options.slices : 1;
}

// Eye-space z / far.
void widen_depths(FrameContext& frame, const GBuffer& gbuffer, glm::vec2& range) {
  const GlTexture blocks(TexelFormat::rg32f, blocks_along(gbuffer.width), blocks_along(gbuffer.height));
  const Program& program = frame.fullscreen_program("shaders/depth_range.frag.glsl");
  program.set("block_size", kMeasuredBlock);
  gbuffer.bind();
  frame.draw_fullscreen(Framebuffer({&blocks}), program);
  const Image ranges = read_back(blocks, 2);
  for (std::size_t i = 0; i < ranges.data.size(); i += 2)
    range = glm::vec2(std::min(range.x, ranges.data[i]), std::max(range.y, ranges.data[i + 1]));
}

void slice_seen_depths(FrameContext& frame, std::span<const LitPicture> seen_by, int count,
                       LightBlock& block) {
  glm::vec2 range(1e30f, -1e30f);
  for (const LitPicture& picture : seen_by) widen_depths(frame, picture.gbuffer, range);
  if (range.x <= range.y) slice_depths(block, range.x, range.y, count);
}

// Measured in blocks on the GPU, gathered here.
void measure_seen(FrameContext& frame, const GBuffer& gbuffer, ShadowProjection projection, int views,
                  Seen& seen) {
  const int width = blocks_along(gbuffer.width);
  const int height = blocks_along(gbuffer.height);
  std::array<GlTexture, 6> blocks;
  for (GlTexture& texture : blocks) texture = GlTexture(TexelFormat::rgba32f, width, height);
  const GlTexture depths(TexelFormat::rg32f, width, height);
  const Framebuffer target({&blocks[0], &blocks[1], &blocks[2], &blocks[3], &blocks[4], &blocks[5], &depths});
  ShaderDefines defines = gbuffer_defines(gbuffer);
  for (const std::string& define : projection_defines(projection)) defines.push_back(define);
  const Program& program = frame.fullscreen_program("shaders/shadow_bounds.frag.glsl", defines);
  program.set("block_size", kMeasuredBlock);
  gbuffer.bind();
  frame.draw_fullscreen(target, program);
  for (int view = 0; view < views; ++view) {
    const Image values = read_back(blocks[std::size_t(view)], 4);
    ViewExtent& extent = seen.views[std::size_t(view)];
    for (std::size_t i = 0; i < values.data.size(); i += 4) {
      extent.min = glm::min(extent.min, glm::vec2(values.data[i], values.data[i + 1]));
      extent.max = glm::max(extent.max, glm::vec2(values.data[i + 2], values.data[i + 3]));
    }
  }
  const Image ranges = read_back(depths, 2);
  for (std::size_t i = 0; i < ranges.data.size(); i += 2) {
    seen.nearest = std::min(seen.nearest, ranges.data[i]);
    seen.farthest = std::max(seen.farthest, ranges.data[i + 1]);
  }
}

// The range over which exponential maps count depths from 0 to 1: the size of the lit space that is seen.
float exponential_range(const Seen& seen, ShadowProjection projection) {
  if (seen.nearest > seen.farthest) return 1;
  if (projection != ShadowProjection::orthographic) return seen.farthest;
  const glm::vec2 across = seen.views[0].max - seen.views[0].min;
  return std::max(glm::length(glm::vec3(across, seen.farthest - seen.nearest)), 1e-6f);
}

// Outside its cone a spot lights nothing.
void clip_to_cone(ViewExtent& extent, const Light& light) {
  const float reach = std::tan(light.outer_angle);
  extent.min = glm::max(extent.min, glm::vec2(-reach));
  extent.max = glm::min(extent.max, glm::vec2(reach));
}

int map_size(const ShadowOptions& options, ShadowProjection projection) {
  const bool flat = projection == ShadowProjection::orthographic;
  if (options.mode == ShadowMode::esm) return flat ? options.directional_esm_size : options.esm_size;
  return flat ? options.directional_size : options.point_size;
}

int map_margin(const ShadowOptions& options) {
  if (options.mode == ShadowMode::esm) return options.esm_blur_radius + 2;
  return options.mode == ShadowMode::pcf ? options.pcf_radius + 2 : 2;
}

void require(GlTexture& texture, TexelFormat format, int size, int layers) {
  if (texture.width() == size && texture.layers() == layers) return;
  texture = GlTexture();  // its memory first
  texture = layers > 0 ? GlTexture::array(format, size, size, layers) : GlTexture(format, size, size);
}

void set_caster_state() {
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_GREATER);
}

void draw_depths(FrameContext& frame, const LightBlock& block, int view, ShadowProjection projection,
                 const Framebuffer& target) {
  const Program& solid = frame.program("shaders/caster.vert.glsl", "shaders/caster.frag.glsl");
  const Program& cutout = frame.program("shaders/caster.vert.glsl", "shaders/caster.frag.glsl", {"CUTOUT"});
  target.bind();
  target.clear_depth(0);
  set_caster_state();
  frame.gpu_scene().draw_casters(solid, cutout, shadow_clip_matrix(block, view, projection),
                                 FrustumCulling::on);
}

void blur_in_log_space(FrameContext& frame, const ShadowOptions& options, ShadowProjection projection,
                       int view, ShadowTextures::Maps& maps) {
  const Framebuffer linear({&maps.work[0]}), half_blurred({&maps.work[1]});
  const Framebuffer blurred = Framebuffer::layer(maps.blurred, view);
  const Program& depth =
      frame.fullscreen_program("shaders/esm_depth.frag.glsl", projection_defines(projection));
  const Program& blur = frame.fullscreen_program("shaders/esm_blur.frag.glsl");
  depth.set("view", view);
  maps.depths.bind(8);
  frame.draw_fullscreen(linear, depth);
  blur.set("radius", options.esm_blur_radius);
  blur.set("esm_sharpness", options.esm_sharpness);
  blur.set("direction", glm::ivec2(1, 0));
  maps.work[0].bind(9);
  frame.draw_fullscreen(half_blurred, blur);
  blur.set("direction", glm::ivec2(0, 1));
  maps.work[1].bind(9);
  frame.draw_fullscreen(blurred, blur);
}

}  // namespace

const GlTexture& draw_shadow_map(FrameContext& frame, std::span<const LitPicture> seen_by, const Light& light,
                                 const ShadowOptions& options, ShadowTextures& textures, LightBlock& block) {
  const ShadowProjection projection = shadow_projection(light);
  const int views = view_count(projection, options);
  const int size = map_size(options, projection);
  const bool exponential = options.mode == ShadowMode::esm;
  place_shadow_views(block, light, frame.gpu_scene().bounds());
  block.shadow_extent.x = float(size);
  block.shadow_extent.y = 1.0f / float(size);
  if (projection == ShadowProjection::orthographic) slice_seen_depths(frame, seen_by, views, block);
  const Buffer unfitted(&block, sizeof block);
  unfitted.bind_uniform(1);
  Seen seen;
  for (const LitPicture& picture : seen_by) measure_seen(frame, picture.gbuffer, projection, views, seen);
  if (projection == ShadowProjection::perspective) clip_to_cone(seen.views[0], light);
  const float least = 1e-5f * (projection == ShadowProjection::orthographic ? block.shadow_origin.w : 1.0f);
  for (int view = 0; view < views; ++view)
    fit_view(block.views[std::size_t(view)], seen.views[std::size_t(view)], least, size, map_margin(options));
  block.shadow_extent.z = exponential_range(seen, projection);
  const Buffer fitted(&block, sizeof block);
  fitted.bind_uniform(1);
  ShadowTextures::Maps& maps = textures.of_projection[std::size_t(projection)];
  require(maps.depths, TexelFormat::depth32f, size, views);
  if (exponential) {
    require(maps.blurred, TexelFormat::r32f, size, views);
    for (GlTexture& work : maps.work) require(work, TexelFormat::r32f, size, 0);
  }
  for (int view = 0; view < views; ++view) {
    if (seen.views[std::size_t(view)].empty()) continue;
    draw_depths(frame, block, view, projection, Framebuffer::layer(maps.depths, view));
    if (exponential) blur_in_log_space(frame, options, projection, view, maps);
  }
  return exponential ? maps.blurred : maps.depths;
}

}  // namespace lightbench
