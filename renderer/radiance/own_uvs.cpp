#include "renderer/radiance/own_uvs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "renderer/radiance/surface_charts.h"
#include "renderer/radiance/texel_cover.h"
#include "renderer/radiance/union_find.h"
#include "renderer/radiance/weld.h"

namespace lightbench {
namespace {

// Twice the area over the square of the longest edge, below which UVs are a line to the rounding of floats.
constexpr double kLeastHeight = 1e-7;

struct UvBox {
  glm::dvec2 low{std::numeric_limits<double>::max()};
  glm::dvec2 high{std::numeric_limits<double>::lowest()};

  /// 0..1; 0 where the box has no extent.
  glm::dvec2 place(const glm::dvec2& uv) const {
    const glm::dvec2 extent = high - low;
    return {extent.x > 0 ? (uv.x - low.x) / extent.x : 0, extent.y > 0 ? (uv.y - low.y) / extent.y : 0};
  }
};

UvBox box_of(const Mesh& mesh) {
  UvBox box;
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      box.low = glm::min(box.low, glm::dvec2(mesh.uvs[triangle[i]]));
      box.high = glm::max(box.high, glm::dvec2(mesh.uvs[triangle[i]]));
    }
  return box;
}

std::vector<std::uint32_t> weld_positions_and_uvs(const Mesh& mesh) {
  return weld<5>(mesh.positions.size(), [&](std::uint32_t i) {
    const glm::vec3& p = mesh.positions[i];
    return std::array{p.x, p.y, p.z, mesh.uvs[i].x, mesh.uvs[i].y};
  });
}

std::vector<std::uint32_t> connected_pieces(const Mesh& mesh, const std::vector<bool>& in_no_chart) {
  const std::vector<std::uint32_t> welded = weld_positions_and_uvs(mesh);
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> edges;  // ends, triangle
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3 && !in_no_chart[t]; ++k) {
      const auto [low, high] =
          std::minmax({welded[mesh.triangles[t][k]], welded[mesh.triangles[t][(k + 1) % 3]]});
      edges.emplace_back(low, high, t);
    }
  std::ranges::sort(edges);
  UnionFind pieces(mesh.triangles.size());
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const auto& [low, high, triangle] = edges[i];
    const auto& [last_low, last_high, last_triangle] = edges[i - 1];
    if (low == last_low && high == last_high) pieces.join(triangle, last_triangle);
  }
  std::vector<std::uint32_t> charts(mesh.triangles.size());
  for (std::uint32_t t = 0; t < charts.size(); ++t) charts[t] = in_no_chart[t] ? kNoChart : pieces.find(t);
  return charts;
}

bool is_line(const glm::dvec2& e1, const glm::dvec2& e2) {
  const double longest = std::max({glm::length(e1), glm::length(e2), glm::length(e2 - e1)});
  return std::abs(e1.x * e2.y - e1.y * e2.x) <= kLeastHeight * longest * longest;
}

bool is_in_unit_square(const glm::vec2& uv) {
  return uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1;  // not so for NaN
}

}  // namespace

OwnUvs place_own_uvs(const Mesh& mesh, glm::ivec2 size, const std::vector<bool>& in_no_chart) {
  const UvBox box = box_of(mesh);
  OwnUvs own{{}, connected_pieces(mesh, in_no_chart)};
  own.coordinates.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const glm::dvec2 p = box.place(mesh.uvs[mesh.triangles[t][i]]);
      own.coordinates[t][std::size_t(i)] = 0.5 + glm::dvec2(p.x, 1 - p.y) * glm::dvec2(size - 1);
    }
  return own;
}

glm::dvec2 size_for_own_uvs(const Mesh& mesh, const glm::mat4& transform, double texels_per_unit) {
  const UvBox box = box_of(mesh);
  glm::dvec2 sum(0);
  double area = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto p = world_corners(mesh, transform, t);
    const glm::uvec3& v = mesh.triangles[t];
    const glm::dvec2 origin = box.place(mesh.uvs[v[0]]);
    const glm::dvec2 t1 = box.place(mesh.uvs[v[1]]) - origin, t2 = box.place(mesh.uvs[v[2]]) - origin;
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
    const double uv_area = t1.x * t2.y - t1.y * t2.x, weight = glm::length(glm::cross(e1, e2));
    if (is_line(t1, t2) || !(weight > 0)) continue;
    const glm::dvec3 along_u = (t2.y * e1 - t1.y * e2) / uv_area, along_v = (t1.x * e2 - t2.x * e1) / uv_area;
    sum += weight * glm::dvec2(glm::length(along_u), glm::length(along_v));
    area += weight;
  }
  return 1.0 + texels_per_unit * (area > 0 ? sum / area : glm::dvec2(0));
}

std::string problem_of_uvs(const Mesh& mesh, const std::vector<bool>& in_no_chart) {
  if (mesh.uvs.empty()) return "it has no UVs";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::uvec3& v = mesh.triangles[t];
    for (int i = 0; i < 3; ++i)
      if (const glm::vec2 uv = mesh.uvs[v[i]]; !is_in_unit_square(uv))
        return fmt::format("the UV ({}, {}) of triangle {} lies outside [0, 1]", uv.x, uv.y, t);
    const glm::dvec2 origin(mesh.uvs[v[0]]);
    if (!in_no_chart[t] && is_line(glm::dvec2(mesh.uvs[v[1]]) - origin, glm::dvec2(mesh.uvs[v[2]]) - origin))
      return fmt::format("triangle {} has no area in its UVs", t);
  }
  return "";
}

}  // namespace lightbench
