#include "renderer/radiance/texel_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace lightbench {
namespace {

using Corners = std::array<glm::dvec2, 3>;

// In texels: how far inside a triangle or a cell something must reach to count. Far above the rounding of
// doubles of 16384, far below what shows in a lookup.
constexpr double kTouch = 1e-6;
// The barycentric coordinate from which on a centre counts as inside two triangles at once.
constexpr double kInside = 1e-3;
constexpr std::uint32_t kNone = 0xffffffff;

struct Interval {
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Of the x of a triangle where bottom <= y <= top.
Interval slab_of(const Corners& corners, double bottom, double top) {
  Interval range;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 &from = corners[i], &to = corners[(i + 1) % 3];
    if (from.y >= bottom && from.y <= top) range.add(from.x);
    for (const double y : {bottom, top})
      if ((from.y < y) != (to.y < y)) range.add(from.x + (to.x - from.x) * (y - from.y) / (to.y - from.y));
  }
  return range;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// (beta, gamma) of a point.
glm::dvec2 barycentrics(const Corners& corners, const glm::dvec2& point) {
  const glm::dvec2 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0], p = point - corners[0];
  return glm::dvec2(cross(p, e2), cross(e1, p)) / cross(e1, e2);
}

/// The nearest in the triangle, but for rounding, of a point that is in it but for rounding.
glm::dvec2 clamped(glm::dvec2 b) {
  b = glm::max(b, 0.0);
  return b / std::max(b.x + b.y, 1.0);
}

// In texels, from a gutter. Extrapolating over more is worse than taking the nearest texel, and a piece that
// has none within the larger distance is not there at this size.
constexpr int kExtrapolated = 2;
constexpr int kNearby = 8;

int square(const glm::ivec2& step) {
  return step.x * step.x + step.y * step.y;
}

/// The steps to all places nearby, the nearest first.
std::vector<glm::ivec2> steps_nearby() {
  std::vector<glm::ivec2> steps;
  for (int y = -kNearby; y <= kNearby; ++y)
    for (int x = -kNearby; x <= kNearby; ++x)
      if (x != 0 || y != 0) steps.emplace_back(x, y);
  std::ranges::stable_sort(steps, {}, square);
  return steps;
}

class Cover {
 public:
  explicit Cover(const TexelTriangles& triangles)
      : in_(triangles),
        covering_(std::size_t(triangles.size.x) * std::size_t(triangles.size.y), kNone),
        owner_(covering_.size(), kNoChart) {}

  TexelCover run() {
    for (std::uint32_t t = 0; t < in_.charts.size() && !result_.problem; ++t)
      if (in_.charts[t] != kNoChart) cover(t);
    if (!result_.problem) list_surface();
    if (!result_.problem) list_gutters();
    return std::move(result_);
  }

 private:
  std::size_t index(const glm::ivec2& p) const {
    return std::size_t(p.y) * std::size_t(in_.size.x) + std::size_t(p.x);
  }
  bool contains(const glm::ivec2& p) const {
    return p.x >= 0 && p.y >= 0 && p.x < in_.size.x && p.y < in_.size.y;
  }

  /// A triangle's corners where the texels' centres are at whole numbers.
  Corners corners_of(std::uint32_t triangle) const {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = glm::dvec2(in_.coordinates[triangle][i]) - 0.5;
    return corners;
  }

  void cover(std::uint32_t triangle) {
    const Corners corners = corners_of(triangle);
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const bool has_area = cross(corners[1] - corners[0], corners[2] - corners[0]) != 0;
    for (int y = int(std::ceil(low - kTouch)); has_area && y <= high + kTouch; ++y) {
      const Interval row = slab_of(corners, std::max(y - kTouch, low), std::min(y + kTouch, high));
      for (int x = int(std::ceil(row.low - kTouch)); x <= row.high + kTouch; ++x)
        put_surface({x, y}, triangle);
    }
    for (int y = int(std::floor(low + kTouch)); y < high - kTouch; ++y) {
      const Interval row = slab_of(corners, y, y + 1.0);
      for (int x = int(std::floor(row.low + kTouch)); x < row.high - kTouch; ++x)
        for (const glm::ivec2 step : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}})
          own(glm::ivec2(x, y) + step, triangle);
    }
  }

  bool is_inside(const glm::ivec2& place, std::uint32_t triangle) const {
    const glm::dvec2 b = barycentrics(corners_of(triangle), place);
    return std::min({b.x, b.y, 1 - b.x - b.y}) > kInside;
  }

  void put_surface(const glm::ivec2& place, std::uint32_t triangle) {
    own(place, triangle);
    if (result_.problem) return;
    std::uint32_t& covering = covering_[index(place)];
    if (covering == kNone)
      covering = triangle;
    else if (is_inside(place, covering) && is_inside(place, triangle))
      result_.problem =
          fmt::format("triangles {} and {} overlap at texel ({}, {})", covering, triangle, place.x, place.y);
  }

  void own(const glm::ivec2& place, std::uint32_t triangle) {
    std::uint32_t& owner = owner_[index(place)];
    if (owner != kNoChart && owner != in_.charts[triangle] && !result_.problem)
      result_.problem = fmt::format("two pieces are too close to each other at texel ({}, {}), triangle {}",
                                    place.x, place.y, triangle);
    owner = in_.charts[triangle];
  }

  /// From here on covering_ holds places in the list.
  void list_surface() {
    for (int y = 0; y < in_.size.y; ++y)
      for (int x = 0; x < in_.size.x; ++x) {
        std::uint32_t& covering = covering_[index({x, y})];
        if (covering == kNone) continue;
        const glm::vec2 b = clamped(barycentrics(corners_of(covering), {x, y}));
        result_.surface.push_back({{x, y}, covering, b.x, b.y});
        covering = std::uint32_t(result_.surface.size() - 1);
      }
  }

  void list_gutters() {
    for (int y = 0; y < in_.size.y; ++y)
      for (int x = 0; x < in_.size.x && !result_.problem; ++x)
        if (const std::size_t i = index({x, y}); owner_[i] != kNoChart && covering_[i] == kNone)
          put_gutter({x, y}, owner_[i]);
  }

  std::uint32_t surface_at(const glm::ivec2& place, std::uint32_t chart) const {
    return contains(place) && owner_[index(place)] == chart ? covering_[index(place)] : kNone;
  }

  /// The anchor's chart goes on in the direction of `step` if the one next to it there is surface.
  std::optional<GutterTexel> by_anchor(const glm::ivec2& place, std::uint32_t a, std::uint32_t chart) const {
    if (in_.anchors.empty()) return std::nullopt;
    const glm::ivec2 anchor = in_.anchors[chart], step = place - result_.surface[a].place;
    const std::uint32_t b = surface_at(anchor + step, chart), c = surface_at(anchor, chart);
    if (b == kNone || c == kNone) return std::nullopt;
    return GutterTexel{place, a, b, c};
  }

  std::optional<GutterTexel> best_recipe(const glm::ivec2& place, std::uint32_t chart) const {
    std::optional<GutterTexel> anchored, nearest;
    for (const glm::ivec2& step : near_) {
      if (nearest && square(step) > kExtrapolated * kExtrapolated) break;
      const std::uint32_t a = surface_at(place + step, chart);
      if (a == kNone) continue;
      const std::uint32_t c = surface_at(place + 2 * step, chart);
      if (c != kNone) return GutterTexel{place, a, a, c};
      if (!anchored) anchored = by_anchor(place, a, chart);
      if (!nearest) nearest = GutterTexel{place, a, a, a};
    }
    return anchored ? anchored : nearest;
  }

  void put_gutter(const glm::ivec2& place, std::uint32_t chart) {
    const std::optional<GutterTexel> recipe = best_recipe(place, chart);
    if (recipe)
      result_.gutters.push_back(*recipe);
    else
      result_.problem = fmt::format("a piece at texel ({}, {}) is too small for this size", place.x, place.y);
  }

  const TexelTriangles& in_;
  const std::vector<glm::ivec2> near_ = steps_nearby();
  std::vector<std::uint32_t> covering_;  ///< the triangle that a texel's centre lies in
  std::vector<std::uint32_t> owner_;     ///< the chart whose lookups read a texel
  TexelCover result_;
};

}  // namespace

TexelCover cover_texels(const TexelTriangles& triangles) {
  return Cover(triangles).run();
}

}  // namespace lightbench
