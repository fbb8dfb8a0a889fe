#pragma once

#include <cmath>
#include <functional>
#include <random>

#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include "renderer/radiance/pca.h"
#include "renderer/radiance/radiance_stack.h"

/// Small stacks made in code.
namespace lightbench::test {

/// `radiance(x, y, direction)` of each texel.
inline HalfStack half_stack(int width, int height, const DirectionGrid& grid,
                            const std::function<glm::vec3(int, int, const glm::vec3&)>& radiance) {
  HalfStack stack{width, height, grid, 1, {}};
  for (int layer = 0; layer < grid.layers(); ++layer) {
    const glm::ivec2 place = grid.place(layer);
    const glm::vec3 direction = grid.direction(place.x, place.y);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const glm::vec3 v = radiance(x, y, direction);
        stack.texels.push_back({glm::packHalf1x16(v.x), glm::packHalf1x16(v.y), glm::packHalf1x16(v.z)});
      }
  }
  return stack;
}

/// A highlight of Phong's, of a strength, that wanders over a coloured surface.
inline HalfStack glossy_stack(int width, int height, const DirectionGrid& grid, float strength) {
  return half_stack(width, height, grid, [&](int x, int y, const glm::vec3& direction) {
    const glm::vec3 mirrored =
        glm::normalize(glm::vec3(2 * float(x) / float(width) - 1, 1, 2 * float(y) / float(height) - 1));
    const float highlight = strength * std::pow(std::max(glm::dot(mirrored, direction), 0.0f), 10.0f);
    return glm::vec3(0.5f, 0.3f, 0.1f) * mirrored.y + highlight;
  });
}

/// Without any structure: a codec can but keep it.
inline HalfStack noise_stack(int width, int height, const DirectionGrid& grid, unsigned seed) {
  std::minstd_rand random(seed);
  const auto number = [&] { return float(random() % 1300) / 1000; };
  return half_stack(width, height, grid, [&](int, int, const glm::vec3&) {
    const float r = number(), g = number(), b = number();
    return glm::vec3(r, g, b);
  });
}

}  // namespace lightbench::test
