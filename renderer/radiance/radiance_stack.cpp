#include "renderer/radiance/radiance_stack.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/packing.hpp>

#include "base/color.h"

namespace lightbench {

ByteStack to_bytes(const HalfStack& stack) {
  std::vector<std::uint8_t> byte_of(65536);
  for (std::size_t bits = 0; bits < byte_of.size(); ++bits) {
    const float linear = std::clamp(glm::unpackHalf1x16(std::uint16_t(bits)), 0.0f, 1.0f);
    byte_of[bits] = std::uint8_t(std::lround(255 * srgb_encode(linear)));
  }
  ByteStack bytes{stack.width, stack.height, stack.grid, stack.scale, {}};
  bytes.texels.reserve(stack.texels.size());
  for (const auto& texel : stack.texels)
    bytes.texels.push_back({byte_of[texel[0]], byte_of[texel[1]], byte_of[texel[2]]});
  return bytes;
}

}  // namespace lightbench
