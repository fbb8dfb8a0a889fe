#include "renderer/caustics/volume_cuts.h"

#include <algorithm>

#include <glad/gl.h>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/caustics/map_blocks.h"
#include "renderer/frame_context.h"

namespace lightbench {
namespace {

// Storage blocks of mark_cuts, count_cuts, place_cuts and list_cuts.
enum Block : unsigned { kRays, kCorners, kMarks, kCounts, kCuts };
// Of volume.vert.glsl and volume.frag.glsl.
enum DrawnBlock : unsigned { kDrawnCuts = 2, kDrawnRays, kDrawnWays, kDrawnCorners, kDrawnSpots };

constexpr int kMostCuts = 1 << 20;     // listed at a time: 4 MB
constexpr int kMostVolumes = 1 << 16;  // of the 19 bits that cuts.glsl has for them

int groups_of(int invocations) {
  return (invocations + kComputeGroup - 1) / kComputeGroup;
}

Buffer unset(int count, std::size_t size) {
  return {nullptr, std::size_t(count) * size};
}

}  // namespace

VolumeCuts::VolumeCuts(FrameContext& frame, const ReceiverMap& map, const Volumes& volumes, int slices)
    : frame_(frame),
      map_(map),
      volumes_(volumes),
      slices_(slices),
      words_(slices / 32 + 1),
      at_a_time_(std::min({volumes.triangle_count, kMostVolumes, kMostCuts / (slices + 1)})),
      blocks_(map_blocks(frame, map, slices)),
      marks_(unset(at_a_time_ * words_, sizeof(std::uint32_t))),
      counts_(unset(groups_of(at_a_time_), sizeof(std::uint32_t))),
      cuts_(unset(at_a_time_ * (slices + 1), sizeof(std::uint32_t))) {
  DrawVolumes once;
  once.instances = 1;
  command_ = Buffer(&once, sizeof once);
}

bool VolumeCuts::list_next() {
  if (next_ >= volumes_.triangle_count) return false;
  first_ = next_;
  next_ = std::min(first_ + at_a_time_, volumes_.triangle_count);
  const int listed = next_ - first_;
  const Program& mark = frame_.compute_program(kMarkCuts);
  mark.set("first", first_);
  mark.set("listed", listed);
  mark.set("slices", slices_);
  mark.set("words", words_);
  map_.places.bind(0);
  volumes_.places.bind_storage(kRays);
  volumes_.corners.bind_storage(kCorners);
  blocks_.bind_storage(kMapBlocksBlock);
  marks_.bind_storage(kMarks);
  frame_.compute(mark, listed * words_);
  const Program& count = frame_.compute_program(kCountCuts);
  count.set("listed", listed);
  count.set("words", words_);
  counts_.bind_storage(kCounts);
  frame_.compute(count, listed);
  const Program& place = frame_.compute_program(kPlaceCuts);
  place.set("groups", groups_of(listed));
  command_.bind_storage(kDrawVolumesBlock);
  frame_.compute(place, 1);
  const Program& list = frame_.compute_program(kListCuts);
  list.set("listed", listed);
  list.set("words", words_);
  cuts_.bind_storage(kCuts);
  frame_.compute(list, listed);
  return true;
}

void VolumeCuts::draw(const Program& program) const {
  program.set("first", first_);
  cuts_.bind_storage(kDrawnCuts);
  volumes_.places.bind_storage(kDrawnRays);
  volumes_.ways.bind_storage(kDrawnWays);
  volumes_.corners.bind_storage(kDrawnCorners);
  volumes_.spots.bind_storage(kDrawnSpots);
  glBindVertexArray(no_attributes_.id());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, command_.id());
  glDrawArraysIndirect(GL_TRIANGLES, nullptr);
}

}  // namespace lightbench
