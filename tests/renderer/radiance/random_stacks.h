#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include <rapidcheck/gtest.h>

#include "renderer/radiance/radiance_stack.h"

/// Small objects of many kinds, for properties that must hold of all.
namespace lightbench {

enum class Content { walk, lobe, constant, noise, saturated };

inline std::uint8_t to_byte(double value) {
  return std::uint8_t(std::clamp(value, 0.0, 255.0));
}

/// One component of one texel along its layers.
class RandomCurve {
 public:
  RandomCurve(Content content, int layers, std::mt19937& random) : content_(content), random_(random) {
    value_ = draw(0, 255);
    centre_ = draw(0, layers);
    width_ = draw(1, 1 + layers);
  }

  std::uint8_t operator()(int layer) {
    const double off = (layer - centre_) / width_;
    switch (content_) {
      case Content::walk:
        return to_byte(value_ += draw(-3, 3));
      case Content::lobe:
        return to_byte(value_ / 2 + 120 * std::exp(-off * off));
      case Content::constant:
        return to_byte(value_);
      case Content::noise:
        return to_byte(draw(0, 256));
      case Content::saturated:
        return to_byte(40 + 800 * std::exp(-off * off));
    }
    return 0;
  }

 private:
  double draw(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

  Content content_;
  std::mt19937& random_;
  double value_, centre_, width_;
};

inline ByteStack random_stack(Content content, const DirectionGrid& grid, int width, int height,
                              unsigned seed) {
  ByteStack stack{width, height, grid, 1.5f, {}};
  stack.texels.resize(stack.layer_size() * std::size_t(grid.layers()));
  std::mt19937 random(seed);
  for (std::size_t texel = 0; texel < stack.layer_size(); ++texel)
    for (std::size_t c = 0; c < 3; ++c) {
      RandomCurve curve(content, grid.layers(), random);
      for (int layer = 0; layer < grid.layers(); ++layer)
        stack.texels[std::size_t(layer) * stack.layer_size() + texel][c] = curve(layer);
    }
  return stack;
}

/// Within a RapidCheck property: any content, any order, up to 100 texels (more than a block of the encoder).
inline ByteStack any_stack() {
  const auto content =
      *rc::gen::element(Content::walk, Content::lobe, Content::constant, Content::noise, Content::saturated);
  const DirectionGrid grid{
      *rc::gen::inRange(2, 12), *rc::gen::inRange(1, 12),
      *rc::gen::element(LayerOrder::theta_major, LayerOrder::phi_major, LayerOrder::phi_serpentine)};
  const int width = *rc::gen::inRange(1, 11), height = *rc::gen::inRange(1, 11);
  return random_stack(content, grid, width, height, *rc::gen::arbitrary<unsigned>());
}

}  // namespace lightbench
