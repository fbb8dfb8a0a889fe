#pragma once

#include "renderer/caustics/receiver_map.h"
#include "renderer/gl_program.h"

namespace lightbench {

class FrameContext;

/// What can stop light beside its way along a receiver's axis: waves bend light aside, so that on its way to
/// a texel it passes what the map shows in others. What stands beside the receiver's box is in no texel and
/// stops none.
class OccluderMap {
 public:
  /// Draws the second layer of the map. `most_step`: by how much rays move over the map for each unit of
  /// depth, at most; each is followed in at most so many steps.
  OccluderMap(FrameContext& frame, const ReceiverMap& map, const glm::vec2& most_step, int steps);

  /// For programs with techniques/caustics/occlusion.glsl.
  void set_uniforms(const Program& program) const;

 private:
  int steps_;
  GlTexture exits_;  ///< of draw_exits
  int block_;        ///< texels along an edge of the map's blocks
  /// R32F, a texel for each block: the least depth of what can stop light on its way to the receiver there,
  /// or 2.
  GlTexture ceilings_;
};

}  // namespace lightbench
