#include "renderer/radiance/chart_layout.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "base/error.h"
#include "renderer/radiance/rectangle_packing.h"

namespace lightbench {
namespace {

// Within a factor of two, in the search for a density: to a part in 4000, as textures have some 1000 texels.
constexpr int kBisections = 12;
// Of a density that fits, so that it still does when rounded to four digits.
constexpr double kRounded = 0.9995;

int area(const glm::ivec2& size) {
  return size.x * size.y;
}

/// One step is the least: with texels at both of its ends, a leg has two.
int steps_along(double length, double density) {
  return std::max(1, int(std::lround(std::min(length * density, double(kMaxAtlasSide)))));
}

/// How many texels of a row lookups in a half read, whose right angle is at the row's start. A row is read
/// most by the cells below it.
int row_length(const glm::ivec2& steps, int row) {
  const int left = steps.y - std::max(row - 1, 0);
  return 1 + (steps.x * left + steps.y - 1) / steps.y;
}

/// How wide a rectangle must be for two equal halves, one turned round and `shift` texels higher, to share no
/// texel.
int width_of_two(const glm::ivec2& steps, int shift) {
  int width = steps.x + 1;
  for (int row = shift; 2 * row <= steps.y + shift; ++row)  // the other rows are the same, turned round
    width = std::max(width, row_length(steps, row) + row_length(steps, steps.y - (row - shift)));
  return width;
}

/// The smallest rectangle for two equal halves. Further shifts only make it larger: from 1 on, each takes a
/// texel from the width at most.
glm::ivec2 size_of_two(const glm::ivec2& steps) {
  const glm::ivec2 level(width_of_two(steps, 0), steps.y + 1), shifted(width_of_two(steps, 1), steps.y + 2);
  return area(level) <= area(shifted) ? level : shifted;
}

/// Two halves share a rectangle, of the larger steps of both, where that is smaller than one for each.
std::optional<ChartRectangle> share(const ChartRectangle& a, const ChartRectangle& b, int widest) {
  const glm::ivec2 steps = glm::max(a.steps, b.steps);
  const glm::ivec2 size = size_of_two(steps);
  if (size.x > widest || area(size) > area(a.size) + area(b.size)) return std::nullopt;
  return ChartRectangle{{}, size, steps, a.first, b.first, false};
}

/// None of the shared rectangles is wider than `widest`.
void add_halves(std::vector<ChartRectangle>& halves, int widest, std::vector<ChartRectangle>& rectangles) {
  std::ranges::sort(halves, {}, [](const ChartRectangle& half) {
    return std::tuple(half.steps.y, half.steps.x, half.first.triangle);
  });
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const auto shared = i + 1 < halves.size() ? share(halves[i], halves[i + 1], widest) : std::nullopt;
    rectangles.push_back(shared ? *shared : halves[i]);
    if (shared) ++i;
  }
}

std::vector<ChartRectangle> rectangles_of(std::span<const SurfaceChart> charts, double density, int widest) {
  std::vector<ChartRectangle> rectangles, halves;
  rectangles.reserve(charts.size());
  for (const SurfaceChart& chart : charts) {
    const glm::ivec2 steps(steps_along(chart.u_length, density), steps_along(chart.v_length, density));
    (chart.second ? rectangles : halves)
        .push_back({{}, steps + 1, steps, chart.first, chart.second, chart.second.has_value()});
  }
  add_halves(halves, widest, rectangles);
  return rectangles;
}

std::vector<glm::ivec2> sizes_of(std::span<const ChartRectangle> rectangles) {
  std::vector<glm::ivec2> sizes;
  sizes.reserve(rectangles.size());
  for (const ChartRectangle& rectangle : rectangles) sizes.push_back(rectangle.size);
  return sizes;
}

double total_area(std::span<const ChartRectangle> rectangles) {
  double sum = 0;
  for (const ChartRectangle& rectangle : rectangles) sum += area(rectangle.size);
  return sum;
}

void put(std::span<ChartRectangle> rectangles, const RectanglePacking& packing) {
  for (std::size_t i = 0; i < rectangles.size(); ++i) rectangles[i].place = packing.places[i];
}

/// Nothing where that is beyond what a texture can be.
std::optional<ChartLayout> square_layout(std::span<const SurfaceChart> charts, double density) {
  ChartLayout layout{{}, rectangles_of(charts, density, kMaxAtlasSide)};
  if (total_area(layout.rectangles) > double(kMaxAtlasSide) * kMaxAtlasSide) return std::nullopt;
  const RectanglePacking packing = pack_about_square(sizes_of(layout.rectangles));
  put(layout.rectangles, packing);
  layout.size = glm::max(packing.size, 1);
  if (std::max(layout.size.x, layout.size.y) > kMaxAtlasSide) return std::nullopt;
  return layout;
}

/// The layout of a density, where it fits.
std::optional<ChartLayout> layout_within(std::span<const SurfaceChart> charts, double density,
                                         const glm::ivec2& size) {
  ChartLayout layout{size, rectangles_of(charts, density, size.x)};
  const auto too_wide = [&](const ChartRectangle& rectangle) { return rectangle.size.x > size.x; };
  if (std::ranges::any_of(layout.rectangles, too_wide)) return std::nullopt;
  if (total_area(layout.rectangles) > double(size.x) * size.y) return std::nullopt;
  const RectanglePacking packing = pack_on_shelves(sizes_of(layout.rectangles), size.x);
  if (packing.size.y > size.y) return std::nullopt;
  put(layout.rectangles, packing);
  return layout;
}

/// A layout and its density.
using Fit = std::pair<ChartLayout, double>;

/// Beyond it, charts are wider than the texture, or have more texels altogether.
double highest_density(std::span<const SurfaceChart> charts, const glm::ivec2& size) {
  double longest = 0, surface = 0;
  for (const SurfaceChart& chart : charts) {
    longest = std::max(longest, chart.u_length);
    surface += chart.u_length * chart.v_length * (chart.second ? 1 : 0.5);
  }
  return std::min(size.x / longest, std::sqrt(double(size.x) * size.y / surface));
}

/// Larger densities may fit where smaller ones do not, by luck of the packing: what is found is the end of an
/// interval of those that fit.
std::optional<Fit> densest(std::span<const SurfaceChart> charts, const glm::ivec2& size) {
  std::optional<ChartLayout> smallest = layout_within(charts, 0, size);
  if (!smallest) return std::nullopt;
  Fit best{std::move(*smallest), 0};
  if (charts.empty()) return best;
  const auto attempt = [&](double density) {
    std::optional<ChartLayout> layout = layout_within(charts, density, size);
    if (layout) best = {std::move(*layout), density};
    return layout.has_value();
  };
  double high = highest_density(charts, size);
  while (high > 0 && !attempt(high / 2)) high /= 2;  // low enough ones give the smallest charts, which fit
  double low = high / 2;
  for (int i = 0; i < kBisections; ++i) (attempt((low + high) / 2) ? low : high) = (low + high) / 2;
  return best;
}

}  // namespace

ChartLayout fit_charts(std::span<const SurfaceChart> charts, glm::ivec2 size, const std::string& where) {
  const bool transposed = size.x < size.y;  // shelves are best laid along the longer side
  if (transposed) std::swap(size.x, size.y);
  std::optional<Fit> fit = densest(charts, size);
  if (!fit) {
    const std::optional<ChartLayout> least = square_layout(charts, 0);
    throw Error(fmt::format("the charts of its surface, {} of them, do not fit into {} x {} texels; {}",
                            charts.size(), transposed ? size.y : size.x, transposed ? size.x : size.y,
                            least ? fmt::format("{} x {} would do", least->size.x, least->size.y)
                                  : "no size would do"),
                where);
  }
  ChartLayout layout = std::move(fit->first);
  layout.transposed = transposed;
  if (charts.size() == 1) {
    layout.rectangles[0].size = size;
    layout.rectangles[0].steps = size - 1;
  }
  return layout;
}

ChartLayout place_charts(std::span<const SurfaceChart> charts, double texels_per_unit,
                         const std::string& where) {
  if (std::optional<ChartLayout> layout = square_layout(charts, texels_per_unit)) return *layout;
  const std::optional<Fit> fit = densest(charts, glm::ivec2(kMaxAtlasSide));
  throw Error(
      fmt::format("with {} texels per unit its surface takes more than {} x {} texels; {}", texels_per_unit,
                  kMaxAtlasSide, kMaxAtlasSide,
                  fit && fit->second > 0 ? fmt::format("up to {:.4g} would do", kRounded * fit->second)
                                         : "it has too many triangles for any density"),
      where);
}

}  // namespace lightbench
