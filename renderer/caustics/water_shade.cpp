#include "renderer/caustics/water_shade.h"

#include <glad/gl.h>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/frame_context.h"
#include "renderer/gpu_scene.h"

namespace lightbench {
namespace {

constexpr int kSize = 1024;

/// Onto the water's level, away from the light: the rectangle fills the target. Depths are all the same.
glm::dmat4 clip_from_world(const Water& water, const Light& light) {
  const double level = water.height;
  glm::dvec4 x, z, w;  // rows: places on the level times w, and w
  if (light.kind == LightKind::directional) {
    const glm::dvec3 slope = glm::dvec3(light.direction) / double(light.direction.y);
    x = {1, -slope.x, 0, level * slope.x};
    z = {0, -slope.z, 1, level * slope.z};
    w = {0, 0, 0, 1};
  } else {
    const glm::dvec3 from(light.position);
    x = {from.y - level, -from.x, 0, from.x * level};
    z = {0, -from.z, from.y - level, from.z * level};
    w = {0, -1, 0, from.y};
  }
  const glm::dvec2 low(water.min), size = glm::dvec2(water.max) - low;
  return glm::transpose(
      glm::dmat4(2.0 / size.x * (x - low.x * w) - w, 2.0 / size.y * (z - low.y * w) - w, 0.5 * w, w));
}

}  // namespace

bool reaches_above_water(const FrameContext& frame) {
  return frame.gpu_scene().bounds().max.y > frame.scene().water->height;
}

std::optional<GlTexture> draw_water_shade(FrameContext& frame, const Light& light) {
  if (!reaches_above_water(frame)) return std::nullopt;
  const Water& water = *frame.scene().water;
  GlTexture open(TexelFormat::r8, kSize, kSize, Filter::linear);
  const Framebuffer target({&open});
  target.bind();
  target.clear_color(0, 1, 1, 1, 1);
  set_surface_state();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  const Program& solid = frame.program(kSurfaceVertex, kShadeFragment);
  const Program& cutout = frame.program(kSurfaceVertex, kShadeFragment, {"CUTOUT"});
  const glm::dvec2 middle = 0.5 * (glm::dvec2(water.min) + glm::dvec2(water.max));
  frame.gpu_scene().draw_surfaces(solid, cutout, clip_from_world(water, light),
                                  {middle.x, double(water.height), middle.y}, FrustumCulling::on);
  return open;
}

}  // namespace lightbench
