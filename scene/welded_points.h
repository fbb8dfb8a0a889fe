#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace lightbench {

/// Positions that are equal get the same number; `points` holds each once.
struct WeldedPoints {
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> point_of_position;
};

WeldedPoints weld(const std::vector<glm::vec3>& positions);

}  // namespace lightbench
