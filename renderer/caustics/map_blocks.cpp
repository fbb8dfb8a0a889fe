#include "renderer/caustics/map_blocks.h"

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/frame_context.h"

namespace lightbench {

int blocks_along(const ReceiverMap& map) {
  constexpr int kBlock = 8;  // of blocks.glsl
  return (map.places.width() + kBlock - 1) / kBlock;
}

Buffer map_blocks(FrameContext& frame, const ReceiverMap& map, int slices) {
  const int along = blocks_along(map);
  Buffer blocks(nullptr, std::size_t(along) * std::size_t(along) * sizeof(glm::ivec2));
  const Program& program = frame.compute_program(kBlocks);
  program.set("slices", float(slices));
  map.places.bind(0);
  blocks.bind_storage(0);
  frame.compute(program, along * along);
  return blocks;
}

}  // namespace lightbench
