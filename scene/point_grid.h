#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace lightbench {

/// Points of the plane in the cells of a grid, about two in each, to find those in a rectangle.
class PointGrid {
 public:
  explicit PointGrid(const std::vector<glm::dvec2>& points);

  /// Calls `look(index)` for all points between `min` and `max`, and for some around them, until it returns
  /// true.
  template <typename Look>
  void visit(const glm::dvec2& min, const glm::dvec2& max, Look look) const {
    const glm::ivec2 first = cell(min);
    const glm::ivec2 last = cell(max);
    for (int y = first.y; y <= last.y; ++y) {
      const auto row = std::size_t(y) * std::size_t(side_);
      for (std::uint32_t i = starts_[row + std::size_t(first.x)]; i < starts_[row + std::size_t(last.x) + 1];
           ++i)
        if (look(indices_[i])) return;
    }
  }

 private:
  glm::ivec2 cell(const glm::dvec2& p) const;

  int side_ = 1;  // cells along either axis
  glm::dvec2 min_{0};
  glm::dvec2 cells_per_unit_{0};
  std::vector<std::uint32_t> starts_;  // of each cell's points in indices_, row by row, and the end
  std::vector<std::uint32_t> indices_;
};

}  // namespace lightbench
