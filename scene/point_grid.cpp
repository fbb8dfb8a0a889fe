#include "scene/point_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>

namespace lightbench {

PointGrid::PointGrid(const std::vector<glm::dvec2>& points)
    : side_(std::clamp(int(std::sqrt(double(points.size()) / 2)), 1, 1024)) {
  glm::dvec2 max = min_ = points.at(0);
  for (const glm::dvec2& p : points) {
    min_ = glm::min(min_, p);
    max = glm::max(max, p);
  }
  for (int k = 0; k < 2; ++k)
    if (max[k] > min_[k]) cells_per_unit_[k] = side_ / (max[k] - min_[k]);
  const auto index = [&](const glm::dvec2& p) {
    const glm::ivec2 c = cell(p);
    return std::size_t(c.y) * std::size_t(side_) + std::size_t(c.x);
  };
  starts_.assign(std::size_t(side_) * std::size_t(side_) + 1, 0);
  for (const glm::dvec2& p : points) ++starts_[index(p) + 1];
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  indices_.resize(points.size());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < points.size(); ++i) indices_[next[index(points[i])]++] = i;
}

glm::ivec2 PointGrid::cell(const glm::dvec2& p) const {
  return glm::clamp(glm::ivec2((p - min_) * cells_per_unit_), glm::ivec2(0), glm::ivec2(side_ - 1));
}

}  // namespace lightbench
