#pragma once

#include <initializer_list>

#include "reports/metric.h"

namespace lightbench::test {

/// A one-row image of these sRGB pixels.
inline Image8 row_of(std::initializer_list<std::array<std::uint8_t, 3>> pixels) {
  Image8 image(int(pixels.size()), 1, 3);
  std::size_t i = 0;
  for (const auto& pixel : pixels)
    for (const std::uint8_t component : pixel) image.data[i++] = component;
  return image;
}

/// Every component differs from its neighbours, so that no image made so is constant.
inline Image8 pattern(int width, int height, unsigned seed) {
  Image8 image(width, height, 3);
  std::uint32_t state = seed * 2654435761u + 1;
  for (auto& component : image.data) {
    state = state * 1664525u + 1013904223u;
    component = std::uint8_t(state >> 24);
  }
  return image;
}

inline MetricValue compute(const std::string& name, const Image8& reference, const Image8& image,
                           const Image8* baseline = nullptr,
                           const std::vector<std::uint8_t>* mask = nullptr) {
  return compute_metrics({name}, {reference, image, baseline, mask}).at(name);
}

}  // namespace lightbench::test
