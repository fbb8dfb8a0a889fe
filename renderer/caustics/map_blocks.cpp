#include "renderer/caustics/map_blocks.h"

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/frame_context.h"

namespace lightbench {

Buffer map_blocks(FrameContext& frame, const ReceiverMap& map, int slices) {
  constexpr int kBlock = 8;  // of blocks.glsl
  const int along = (map.places.width() + kBlock - 1) / kBlock;
  Buffer blocks(nullptr, std::size_t(along) * std::size_t(along) * sizeof(glm::ivec2));
  const Program& program = frame.compute_program(kBlocks);
  program.set("slices", float(slices));
  map.places.bind(0);
  blocks.bind_storage(0);
  frame.compute(program, along * along);
  return blocks;
}

}  // namespace lightbench
