#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "renderer/radiance/surface_charts.h"

namespace lightbench {

/// A rectangle of texels that holds a chart of two triangles, a chart of one, or two charts of one each whose
/// hypotenuses face each other.
struct ChartRectangle {
  glm::ivec2 place{0};                 ///< the first texel
  glm::ivec2 size;                     ///< in texels
  glm::ivec2 steps;                    ///< along a triangle's legs, from texel centre to texel centre
  TriangleHalf first;                  ///< right angle at the first texel
  std::optional<TriangleHalf> second;  ///< right angle at the last texel
  bool one_chart;                      ///< of the two triangles
};

struct ChartLayout {
  glm::ivec2 size;  ///< of the texture
  std::vector<ChartRectangle> rectangles;
  bool transposed = false;  ///< x and y are to be exchanged in everything, size included
};

inline constexpr int kMaxAtlasSide = 16384;

/// The largest density whose charts fit into `size`; a chart that is alone is stretched to fill it. Throws
/// Error(..., where) when even the smallest charts do not fit, naming a size that would do.
ChartLayout fit_charts(std::span<const SurfaceChart> charts, glm::ivec2 size, const std::string& where);

/// The smallest about square texture with so many texels per unit of length. Throws Error(..., where) when a
/// side is longer than kMaxAtlasSide, naming a density that fits.
ChartLayout place_charts(std::span<const SurfaceChart> charts, double texels_per_unit,
                         const std::string& where);

}  // namespace lightbench
