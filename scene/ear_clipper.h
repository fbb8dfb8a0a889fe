#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/point_grid.h"

namespace lightbench {

/// Twice the area of a triangle, positive where it turns to the left. It is 0 where two corners are the same.
double turn_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// How much work a file's polygons may make together.
struct ClippingBudget {
  std::size_t steps = 2'000'000'000;  ///< looks at corners, for which a polygon takes some ten seconds
  /// The steps that are taken where no ear is left: most such polygons cross themselves, and have no right
  /// triangles.
  std::size_t last_resort_steps = 100'000'000;
};

/// Cuts a polygon of n corners, seen so that most of it turns to the left, into n - 2 triangles by clipping
/// ears. Corners may lie on one another or on other edges, as where a bridge leads to a hole, and edges may
/// run back over one another. Triangles then cover what an odd number of turns goes around, and some have no
/// area. Of a polygon whose edges cross between its corners, and of one that the budget does not suffice for,
/// the rest is cut as it comes.
class EarClipper {
 public:
  EarClipper(const std::vector<glm::dvec2>& points, std::vector<glm::uvec3>& triangles,
             ClippingBudget& budget);

  /// False where the triangles do not cover the polygon exactly.
  bool run();

 private:
  enum class Mode {
    strict,    ///< no other corner touches the ear's new edge
    touching,  ///< others may
  };
  using Heap = std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>>;

  bool is_fold(std::uint32_t i) const;
  void look_again_at(std::uint32_t i);
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void clip(std::uint32_t i);
  void fan();

  std::optional<std::uint32_t> ear();
  std::optional<std::uint32_t> fold();
  std::optional<std::uint32_t> touching_ear();
  std::uint32_t next_corner();
  std::uint32_t flattest();

  bool goes_inside(std::uint32_t corner, std::uint32_t to, const glm::dvec3& sides, std::uint32_t ear) const;
  std::optional<std::uint32_t> blocker(std::uint32_t ear, Mode mode);
  bool is_inside_polygon(std::uint32_t ear);

  const std::vector<glm::dvec2>& points_;
  std::vector<glm::uvec3>& triangles_;
  ClippingBudget& budget_;
  const PointGrid grid_;
  std::vector<std::uint32_t> before_, after_;  // the polygon that is left, as a ring
  std::vector<bool> clipped_;
  std::vector<double> turns_;  // of the corners that are left
  const bool has_repeats_;     // whether several corners have the same place
  std::uint32_t first_ = 0;    // of the corners that are left, the first one
  std::size_t left_;
  Heap ears_;                                        // corners that may be ears
  Heap folds_;                                       // corners where the polygon may turn back on itself
  std::vector<std::vector<std::uint32_t>> waiting_;  // for each corner, those that it kept from being ears
  double covered_ = 0;                               // twice the area of the triangles so far
  double wrong_ = 0;                                 // twice the area of those that turn back, or are no ears
  std::size_t steps_ = 0;
  std::size_t last_resort_steps_ = 0;
};

}  // namespace lightbench
