#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "renderer/radiance/color_set.h"
#include "renderer/radiance/radiance_stack.h"

namespace lightbench {

/// Some neighbouring texels with each one's layers side by side: a stack itself keeps the layers of a texel
/// far apart. Small enough for a core's cache.
class TexelBlock {
 public:
  static constexpr std::size_t kMaxTexels = 64;

  TexelBlock(std::size_t first, const ByteStack& stack)
      : first_(first),
        layers_(std::size_t(stack.grid.layers())),
        texels_(std::min(kMaxTexels, stack.layer_size() - first)),
        values_(texels_ * layers_) {}

  std::size_t texels() const { return texels_; }
  std::span<Rgb8> layers_of(std::size_t texel) {
    return std::span(values_).subspan(texel * layers_, layers_);
  }

  void gather(const ByteStack& stack) {
    for (std::size_t layer = 0; layer < layers_; ++layer)
      for (std::size_t texel = 0; texel < texels_; ++texel)
        values_[texel * layers_ + layer] = stack.texels[layer * stack.layer_size() + first_ + texel];
  }
  void scatter(ByteStack& stack) const {
    for (std::size_t layer = 0; layer < layers_; ++layer)
      for (std::size_t texel = 0; texel < texels_; ++texel)
        stack.texels[layer * stack.layer_size() + first_ + texel] = values_[texel * layers_ + layer];
  }

 private:
  std::size_t first_, layers_, texels_;
  std::vector<Rgb8> values_;
};

}  // namespace lightbench
