#include "renderer/caustics/occluder_map.h"

#include <algorithm>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/frame_context.h"

namespace lightbench {
namespace {

// Texture units of occlusion.glsl.
enum Unit : unsigned { kExitsUnit = 2, kCeilingsUnit };

/// Few enough for shaders that loop over all of them, which OSMesa ends after 65535 rounds.
int block_of(const ReceiverMap& map) {
  constexpr int kMostBlocks = 64;  // along a side
  return std::max(8, (map.places.width() + kMostBlocks - 1) / kMostBlocks);
}

/// RG32F, a texel for each block: the least depth of any surface, and the greatest of the receiver's.
GlTexture draw_block_depths(FrameContext& frame, const ReceiverMap& map, int block) {
  const int blocks = (map.places.width() + block - 1) / block;
  GlTexture depths(TexelFormat::rg32f, blocks, blocks);
  const Program& program = frame.fullscreen_program(kBlockDepths);
  program.set("occluder_block", block);
  map.places.bind(0);
  frame.draw_fullscreen(Framebuffer({&depths}), program);
  return depths;
}

GlTexture draw_ceilings(FrameContext& frame, const ReceiverMap& map, int block, const glm::vec2& most_step) {
  const GlTexture depths = draw_block_depths(frame, map, block);
  const GlTexture least(TexelFormat::r32f, 1, 1);
  depths.bind(0);
  frame.draw_fullscreen(Framebuffer({&least}), frame.fullscreen_program(kLeastDepth));
  GlTexture ceilings(TexelFormat::r32f, depths.width(), depths.height());
  const Program& program = frame.fullscreen_program(kCeilings);
  program.set("occluder_block", block);
  program.set("map_size", glm::ivec2(map.places.width(), map.places.height()));
  program.set("most_step", most_step);
  depths.bind(0);
  least.bind(1);
  frame.draw_fullscreen(Framebuffer({&ceilings}), program);
  return ceilings;
}

}  // namespace

OccluderMap::OccluderMap(FrameContext& frame, const ReceiverMap& map, const glm::vec2& most_step, int steps)
    : steps_(steps),
      exits_(draw_exits(frame, map)),
      block_(block_of(map)),
      ceilings_(draw_ceilings(frame, map, block_, most_step)) {}

void OccluderMap::set_uniforms(const Program& program) const {
  exits_.bind(kExitsUnit);
  ceilings_.bind(kCeilingsUnit);
  program.set("occluder_block", block_);
  program.set("march_steps", steps_);
}

}  // namespace lightbench
