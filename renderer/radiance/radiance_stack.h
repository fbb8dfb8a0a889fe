#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/zeroed_allocator.h"
#include "renderer/radiance/direction_grid.h"

namespace lightbench {

/// What an object sends out: width * height texels over its surface, one layer for each direction. Texels are
/// kept x fastest, then y (row 0 first in the file), then layer; three components, RGB, each.
template <typename Component>
struct RadianceStack {
  int width = 0;
  int height = 0;
  DirectionGrid grid;
  float scale = 1;  ///< the radiance that stands for 1
  using Texels = std::vector<std::array<Component, 3>, ZeroedAllocator<std::array<Component, 3>>>;
  Texels texels;

  std::size_t layer_size() const { return std::size_t(width) * std::size_t(height); }
  std::size_t index(int x, int y, int layer) const {
    return std::size_t(layer) * layer_size() + std::size_t(y) * std::size_t(width) + std::size_t(x);
  }
};

/// 16-bit floats: linear radiance over `scale`, what is above kLargestHalf being kept as that. The bits are
/// those of IEEE binary16.
using HalfStack = RadianceStack<std::uint16_t>;
/// sRGB-encoded, 0..255, of radiance over `scale`, clamped to 1.
using ByteStack = RadianceStack<std::uint8_t>;

/// Rounds to the nearest of 8 bits; what is above `scale` becomes 255.
ByteStack to_bytes(const HalfStack& stack);

}  // namespace lightbench
