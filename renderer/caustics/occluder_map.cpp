#include "renderer/caustics/occluder_map.h"

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/caustics/map_blocks.h"
#include "renderer/frame_context.h"

namespace lightbench {
namespace {

// Texture units of occlusion.glsl.
enum Unit : unsigned { kExitsUnit = 2, kCeilingsUnit };

/// RG32F, a texel for each block: the least depth of any surface, and the greatest of the receiver's.
GlTexture draw_block_depths(FrameContext& frame, const ReceiverMap& map) {
  const int blocks = blocks_along(map);
  GlTexture depths(TexelFormat::rg32f, blocks, blocks);
  const Program& program = frame.fullscreen_program(kBlockDepths);
  map.places.bind(0);
  frame.draw_fullscreen(Framebuffer({&depths}), program);
  return depths;
}

GlTexture draw_ceilings(FrameContext& frame, const ReceiverMap& map, const glm::vec2& most_step) {
  const GlTexture depths = draw_block_depths(frame, map);
  const GlTexture least(TexelFormat::r32f, 1, 1);
  depths.bind(0);
  frame.draw_fullscreen(Framebuffer({&least}), frame.fullscreen_program(kLeastDepth));
  GlTexture ceilings(TexelFormat::r32f, depths.width(), depths.height());
  const Program& program = frame.fullscreen_program(kCeilings);
  program.set("map_size", glm::ivec2(map.places.width(), map.places.height()));
  program.set("most_step", most_step);
  depths.bind(0);
  least.bind(1);
  frame.draw_fullscreen(Framebuffer({&ceilings}), program);
  return ceilings;
}

}  // namespace

OccluderMap::OccluderMap(FrameContext& frame, const ReceiverMap& map, const glm::vec2& most_step, int steps)
    : steps_(steps), exits_(draw_exits(frame, map)), ceilings_(draw_ceilings(frame, map, most_step)) {}

void OccluderMap::set_uniforms(const Program& program) const {
  exits_.bind(kExitsUnit);
  ceilings_.bind(kCeilingsUnit);
  program.set("march_steps", steps_);
}

}  // namespace lightbench
