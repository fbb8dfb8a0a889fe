#pragma once

#include "renderer/caustics/receiver_map.h"
#include "renderer/caustics/volumes.h"

namespace lightbench {

class FrameContext;

/// Each volume with those planes that the receiver lies on in blocks of 8 x 8 texels of its map that the
/// volume's image may touch there: whatever else it is cut by falls on no texel. Found and listed by shaders,
/// for so many volumes at a time that the list has room for all their planes.
class VolumeCuts {
 public:
  /// All must outlive it.
  VolumeCuts(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes, int slices);

  /// False at the end.
  bool list_next();
  /// What list_next listed, by a program of volume.vert.glsl and volume.frag.glsl with LISTED_CUTS, which is
  /// in use with all but its cuts.
  void draw(const Program& program) const;

 private:
  FrameContext& frame_;
  const ReceiverMap& map_;
  const Volumes& volumes_;
  int slices_;
  int words_, at_a_time_;
  int first_ = 0, next_ = 0;
  Buffer blocks_, marks_, counts_, cuts_, command_;
  VertexArray no_attributes_;
};

}  // namespace lightbench
