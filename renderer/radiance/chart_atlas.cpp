#include "renderer/radiance/chart_atlas.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "renderer/radiance/chart_layout.h"
#include "renderer/radiance/own_uvs.h"
#include "renderer/radiance/surface_charts.h"

namespace lightbench {
namespace {

using Corners = std::array<glm::vec2, 3>;

/// An atlas, or why there is none.
struct Attempt {
  ChartAtlas atlas;
  std::string problem;
};

void check_size(const AtlasSize& size, const std::string& where) {
  if (const auto* density = std::get_if<TexelsPerUnit>(&size)) {
    if (!(density->value > 0) || !std::isfinite(density->value))
      throw Error(fmt::format("{} texels per unit of length is not a positive number", density->value),
                  where);
    return;
  }
  const glm::ivec2 given = std::get<glm::ivec2>(size);
  if (std::min(given.x, given.y) < 1 || std::max(given.x, given.y) > kMaxAtlasSide)
    throw Error(fmt::format("{} x {} texels: each side is 1 to {}", given.x, given.y, kMaxAtlasSide), where);
}

double texture_area(const Corners& c) {
  const glm::dvec2 u(c[1] - c[0]), v(c[2] - c[0]);
  return std::abs(u.x * v.y - u.y * v.x) / 2;
}

/// They are never drawn; but should a pixel's lookup happen, it finds the surface next to them.
void place_triangles_without_area(const Mesh& mesh, ChartAtlas& atlas) {
  std::vector<std::optional<glm::vec2>> of_vertex(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3 && atlas.charts[t] != kNoChart; ++i)
      of_vertex[mesh.triangles[t][i]] = atlas.coordinates[t][std::size_t(i)];
  const glm::vec2 any = 0.5f + glm::vec2(atlas.surface.empty() ? glm::ivec2(0) : atlas.surface[0].place);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (atlas.charts[t] != kNoChart) continue;
    glm::vec2 place = any;
    for (int i = 0; i < 3; ++i) place = of_vertex[mesh.triangles[t][i]].value_or(place);
    atlas.coordinates[t].fill(place);
  }
}

Attempt completed(ChartAtlas atlas, const std::vector<glm::ivec2>& anchors, const Mesh& mesh) {
  TexelCover cover = cover_texels({{atlas.width, atlas.height}, atlas.coordinates, atlas.charts, anchors});
  if (cover.problem) return {{}, *cover.problem};
  atlas.surface = std::move(cover.surface);
  atlas.gutters = std::move(cover.gutters);
  place_triangles_without_area(mesh, atlas);
  return {std::move(atlas), ""};
}

ChartAtlas empty_atlas(const glm::ivec2& size, std::size_t triangles) {
  ChartAtlas atlas{size.x, size.y};
  atlas.coordinates.resize(triangles);
  atlas.charts.resize(triangles, kNoChart);
  return atlas;
}

/// The triangles of a layout in the texture.
class Placement {
 public:
  Placement(const ChartLayout& layout, std::size_t triangles)
      : layout_(layout), atlas_(empty_atlas(turned(layout.size), triangles)) {
    for (const ChartRectangle& rectangle : layout.rectangles) place(rectangle);
  }

  Attempt complete(const Mesh& mesh) && { return completed(std::move(atlas_), anchors_, mesh); }

 private:
  template <typename Vector>
  Vector turned(const Vector& p) const {
    return layout_.transposed ? Vector(p.y, p.x) : p;
  }

  void place(const ChartRectangle& rectangle) {
    anchors_.push_back(turned(rectangle.place));
    place_half(rectangle.first, rectangle.place, rectangle.steps);
    if (!rectangle.second) return;
    const glm::ivec2 last = rectangle.place + rectangle.size - 1;
    if (!rectangle.one_chart) anchors_.push_back(turned(last));
    place_half(*rectangle.second, last, -rectangle.steps);
  }

  void place_half(const TriangleHalf& half, const glm::ivec2& right_angle, const glm::ivec2& steps) {
    atlas_.charts[half.triangle] = std::uint32_t(anchors_.size() - 1);
    Corners& corners = atlas_.coordinates[half.triangle];
    corners[half.corners[0]] = turned(glm::vec2(right_angle) + 0.5f);
    corners[half.corners[1]] = turned(glm::vec2(right_angle) + glm::vec2(float(steps.x), 0) + 0.5f);
    corners[half.corners[2]] = turned(glm::vec2(right_angle) + glm::vec2(0, float(steps.y)) + 0.5f);
  }

  const ChartLayout& layout_;
  ChartAtlas atlas_;
  std::vector<glm::ivec2> anchors_;  ///< of each chart: the texel at its right angle
};

ChartAtlas atlas_of_charts(const Mesh& mesh, const std::vector<SurfaceChart>& charts, const AtlasSize& size,
                           const std::string& where) {
  const auto* density = std::get_if<TexelsPerUnit>(&size);
  const ChartLayout layout = density ? place_charts(charts, double(density->value), where)
                                     : fit_charts(charts, std::get<glm::ivec2>(size), where);
  Attempt attempt = Placement(layout, mesh.triangles.size()).complete(mesh);
  assert(attempt.problem.empty());
  return std::move(attempt.atlas);
}

std::vector<bool> triangles_without_chart(const Mesh& mesh, const std::vector<SurfaceChart>& charts) {
  std::vector<bool> without(mesh.triangles.size(), true);
  for (const SurfaceChart& chart : charts) {
    without[chart.first.triangle] = false;
    if (chart.second) without[chart.second->triangle] = false;
  }
  return without;
}

Attempt atlas_of_own_uvs(const Mesh& mesh, const glm::mat4& transform,
                         const std::vector<SurfaceChart>& charts, const AtlasSize& size) {
  const std::vector<bool> without = triangles_without_chart(mesh, charts);
  if (std::string problem = problem_of_uvs(mesh, without); !problem.empty()) return {{}, problem};
  glm::dvec2 sides;
  if (const auto* density = std::get_if<TexelsPerUnit>(&size))
    sides = glm::ceil(size_for_own_uvs(mesh, transform, double(density->value)));
  else
    sides = std::get<glm::ivec2>(size);
  if (!(std::max(sides.x, sides.y) <= kMaxAtlasSide))
    return {{}, fmt::format("the texture would have more than {} texels on a side", kMaxAtlasSide)};
  if (std::min(sides.x, sides.y) < 2) return {{}, "they need two texels on each side"};
  OwnUvs own = place_own_uvs(mesh, sides, without);
  return completed({int(sides.x), int(sides.y), true, std::move(own.coordinates), std::move(own.charts)}, {},
                   mesh);
}

}  // namespace

ChartAtlas make_chart_atlas(const Mesh& mesh, const glm::mat4& transform, const AtlasSize& size, AtlasUvs uvs,
                            const std::string& where) {
  check_size(size, where);
  const std::vector<SurfaceChart> charts = find_charts(mesh, transform);
  if (uvs != AtlasUvs::charts) {
    Attempt own = atlas_of_own_uvs(mesh, transform, charts, size);
    if (own.problem.empty()) return std::move(own.atlas);
    if (uvs == AtlasUvs::own) throw Error("its own UVs cannot serve: " + own.problem, where);
  }
  return atlas_of_charts(mesh, charts, size, where);
}

std::string why_not_own_uvs(const Mesh& mesh, const glm::mat4& transform, const AtlasSize& size) {
  check_size(size, mesh.name);
  return atlas_of_own_uvs(mesh, transform, find_charts(mesh, transform), size).problem;
}

SurfaceTexel inset(const ChartAtlas& atlas, SurfaceTexel texel, float texels) {
  const Corners& corners = atlas.coordinates[texel.triangle];
  const double area = 2 * texture_area(corners);
  const std::array b{double(1 - texel.beta - texel.gamma), double(texel.beta), double(texel.gamma)};
  double part = 0;  // of the way to the centroid
  for (std::size_t i = 0; i < 3; ++i) {
    const double height = area / double(glm::distance(corners[(i + 1) % 3], corners[(i + 2) % 3]));
    const double least = std::min(double(texels) / height, 1.0 / 6);
    if (b[i] < least) part = std::max(part, (least - b[i]) / (1.0 / 3 - b[i]));
  }
  texel.beta += float(part * (1.0 / 3 - b[1]));
  texel.gamma += float(part * (1.0 / 3 - b[2]));
  return texel;
}

AtlasStatistics atlas_statistics(const ChartAtlas& atlas, const Mesh& mesh, const glm::mat4& transform) {
  AtlasStatistics statistics{atlas.surface.size(), atlas.gutters.size()};
  statistics.empty =
      std::size_t(atlas.width) * std::size_t(atlas.height) - statistics.surface - statistics.gutter;
  double least = std::numeric_limits<double>::max(), most = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (atlas.charts[t] == kNoChart) continue;
    const auto p = world_corners(mesh, transform, t);
    const double area = glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2;
    const double per_texel = area / texture_area(atlas.coordinates[t]);
    least = std::min(least, per_texel);
    most = std::max(most, per_texel);
  }
  statistics.least_area = std::min(least, most);
  statistics.most_area = most;
  return statistics;
}

}  // namespace lightbench
