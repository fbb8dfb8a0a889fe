#include "renderer/radiance/texel_values.h"

#include <glm/gtc/packing.hpp>

#include "base/color.h"

namespace lightbench {
namespace {

std::vector<float> encoded_halves() {
  std::vector<float> values(65536);
  for (std::size_t bits = 0; bits < values.size(); ++bits)
    values[bits] = 255 * srgb_encode(std::clamp(glm::unpackHalf1x16(std::uint16_t(bits)), 0.0f, 1.0f));
  return values;
}

}  // namespace

Eigen::MatrixXf texel_values(const HalfStack& stack, std::span<const std::uint32_t> places) {
  static const std::vector<float> value_of = encoded_halves();
  const std::size_t layers = std::size_t(stack.grid.layers());
  Eigen::MatrixXf values(3 * layers, places.size());
  for (std::size_t layer = 0; layer < layers; ++layer) {
    const auto* const texels = stack.texels.data() + layer * stack.layer_size();
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        values.data()[(3 * i + c) * layers + layer] = value_of[texels[places[i]][c]];
  }
  return values;
}

}  // namespace lightbench
