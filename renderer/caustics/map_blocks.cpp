#include "renderer/caustics/map_blocks.h"

#include <vector>

#include "renderer/caustics/caustics_shaders.h"
#include "renderer/frame_context.h"

namespace lightbench {

Buffer map_blocks(FrameContext& frame, const ReceiverMap& map, int slices) {
  constexpr int kBlock = 8;                                             // of blocks.glsl
  std::vector<int> levels{(map.places.width() + kBlock - 1) / kBlock};  // along each side
  while (levels.back() > 1) levels.push_back((levels.back() + 1) / 2);
  int count = 0;
  for (const int along : levels) count += along * along;
  Buffer blocks(nullptr, std::size_t(count) * sizeof(glm::ivec2));
  const Program& program = frame.compute_program(kBlocks);
  program.set("slices", float(slices));
  map.places.bind(0);
  blocks.bind_storage(0);
  frame.compute(program, levels[0] * levels[0]);
  const Program& coarser = frame.compute_program(kCoarserBlocks);
  int first_finer = 0;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const int finer = levels[i - 1], first = first_finer + finer * finer;
    coarser.set("finer", glm::ivec2(finer));
    coarser.set("first_finer", first_finer);
    coarser.set("first", first);
    frame.compute(coarser, levels[i] * levels[i]);
    first_finer = first;
  }
  return blocks;
}

}  // namespace lightbench
