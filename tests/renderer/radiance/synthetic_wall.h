#pragma once

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/vec3.hpp>

#include "renderer/radiance/radiance_stack.h"

namespace lightbench {

/// A shiny grey wall of 2 x 1 under two white lights, one of which something shades along a soft edge.
struct SyntheticWall {
  int width = 200;
  int height = 100;
  DirectionGrid grid;
  float specular = 0.5f;
  std::array<float, 2> exponents{10, 40};  ///< of the Phong lobe of either light
};

inline HalfStack make_stack(const SyntheticWall& wall) {
  constexpr std::array kLights{glm::vec3(0.4f, 0.8f, 0.2f), glm::vec3(1.5f, 1.2f, 0.9f)};
  constexpr std::array kAlbedo{0.7f, 0.6f, 0.4f};
  HalfStack stack{wall.width, wall.height, wall.grid, 1, {}};
  stack.texels.reserve(stack.layer_size() * std::size_t(wall.grid.layers()));
  for (int layer = 0; layer < wall.grid.layers(); ++layer) {
    const glm::ivec2 place = wall.grid.place(layer);
    const glm::vec3 towards_viewer = wall.grid.direction(place.x, place.y);
    for (int y = 0; y < wall.height; ++y)
      for (int x = 0; x < wall.width; ++x) {
        const glm::vec3 point(2 * (float(x) + 0.5f) / float(wall.width), 0,
                              (float(y) + 0.5f) / float(wall.height));
        float diffuse = 0.05f, specular = 0;
        for (std::size_t i = 0; i < kLights.size(); ++i) {
          const glm::vec3 to_light = glm::normalize(kLights[i] - point);
          const float edge = (point.x + 0.3f * point.z - 0.9f) / 0.1f;
          const float visibility = i == 0 ? 1 - glm::clamp(edge, 0.0f, 1.0f) : 1;
          const glm::vec3 mirrored(-to_light.x, to_light.y, -to_light.z);
          diffuse += 0.6f * visibility * to_light.y;
          specular += wall.specular * visibility *
                      std::pow(std::max(glm::dot(mirrored, towards_viewer), 0.0f), wall.exponents[i]);
        }
        const auto component = [&](float albedo) { return glm::packHalf1x16(albedo * diffuse + specular); };
        stack.texels.push_back({component(kAlbedo[0]), component(kAlbedo[1]), component(kAlbedo[2])});
      }
  }
  return stack;
}

}  // namespace lightbench
