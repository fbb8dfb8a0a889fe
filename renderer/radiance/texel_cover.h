#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace lightbench {

/// A texel whose centre lies on the surface: at p0 + beta e1 + gamma e2 of a triangle, where e1 = p1 - p0 and
/// e2 = p2 - p0.
struct SurfaceTexel {
  glm::ivec2 place;
  std::uint32_t triangle;
  float beta;
  float gamma;
};

/// A texel outside a chart that bilinear lookups of points inside it read. Its value is a + b - c of three
/// surface texels of that chart, given as places in the list of them. Since the gutter itself lies at
/// a + b - c, that is linear extrapolation: mostly 2a - c, with a = b next to the gutter and c beyond; in
/// strips of two texels, a and the step from c to b elsewhere. Where there are no such texels, all three are
/// the nearest one. The value may be negative or exceed all others: clamp it where that matters.
struct GutterTexel {
  glm::ivec2 place;
  std::uint32_t a, b, c;
};

inline constexpr std::uint32_t kNoChart = 0xffffffff;

/// Triangles of an object in the plane of its texture. Texel (i, j) has its centre at (i + 0.5, j + 0.5).
struct TexelTriangles {
  glm::ivec2 size;                                        ///< of the texture
  std::span<const std::array<glm::vec2, 3>> coordinates;  ///< of the corners, at least 0.5 from its borders
  std::span<const std::uint32_t> charts;                  ///< of each triangle; kNoChart: it takes no part
  std::span<const glm::ivec2> anchors;  ///< of each chart: a surface texel that has surface texels next to it
                                        ///< in all directions in which the chart goes on; or empty
};

/// Which texels triangles cover; both lists by rows. When the triangles cannot do, `problem` tells why in
/// words (texels shared by two triangles or by two charts, or charts that miss all texel centres), and the
/// lists are not whole.
struct TexelCover {
  std::vector<SurfaceTexel> surface;
  std::vector<GutterTexel> gutters;
  std::optional<std::string> problem;
};
TexelCover cover_texels(const TexelTriangles& triangles);

}  // namespace lightbench
