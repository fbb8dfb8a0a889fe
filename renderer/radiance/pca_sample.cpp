#include "renderer/radiance/pca_sample.h"

#include <algorithm>
#include <random>

#include "renderer/radiance/rgtc.h"

namespace lightbench {
namespace {

constexpr std::uint32_t kSide = kRgtcSide;

/// The numbers of the blocks that have texels at these places, in random order.
std::vector<std::uint32_t> random_blocks(std::uint32_t width, const TexelPlaces& places) {
  const std::uint32_t across = (width + kSide - 1) / kSide;
  std::vector<std::uint32_t> blocks;
  for (const std::uint32_t place : places)
    blocks.push_back(place / width / kSide * across + place % width / kSide);
  std::ranges::sort(blocks);
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  std::mt19937 random(1);
  for (std::size_t i = blocks.size(); i > 1; --i) std::swap(blocks[i - 1], blocks[random() % i]);
  return blocks;
}

}  // namespace

PcaSample sample_blocks(const HalfStack& stack, const TexelPlaces& places, std::size_t count) {
  const std::uint32_t width = std::uint32_t(stack.width), across = (width + kSide - 1) / kSide;
  std::vector<std::uint32_t> blocks = random_blocks(width, places);
  blocks.resize(std::min(blocks.size(), count));
  std::vector<bool> counted(stack.layer_size());
  for (const std::uint32_t place : places) counted[place] = true;

  PcaSample sample{{int(kSide * blocks.size()), int(kSide), stack.grid, stack.scale, {}}, {}};
  TexelPlaces from(sample.stack.layer_size());
  for (std::uint32_t i = 0; i < from.size(); ++i) {
    const std::uint32_t column = i % std::uint32_t(sample.stack.width), block = blocks[column / kSide];
    const std::uint32_t x = block % across * kSide + column % kSide;
    const std::uint32_t y = block / across * kSide + i / std::uint32_t(sample.stack.width);
    if (x >= width || y >= std::uint32_t(stack.height)) continue;
    from[i] = y * width + x;
    if (counted[from[i]]) sample.places.push_back(i);
  }
  for (int layer = 0; layer < stack.grid.layers(); ++layer)
    for (const std::uint32_t place : from)
      sample.stack.texels.push_back(stack.texels[std::size_t(layer) * stack.layer_size() + place]);
  return sample;
}

}  // namespace lightbench
