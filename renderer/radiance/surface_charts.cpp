#include "renderer/radiance/surface_charts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "renderer/radiance/weld.h"

namespace lightbench {
namespace {

// Twice the area over the square of the longest edge, from which on rounding of floats does not make it.
constexpr double kLeastHeight = 1e-7;
constexpr double kSameNormal = 0.9999;  // cosine; under a degree
constexpr double kCoplanar = 0.985;     // cosine of 10 degrees
constexpr double kMostShear = 0.7072;   // cosine of 45 degrees: a rectangle of 1.4 times the area
// How far the fourth corner may be from where a parallelogram has it, over the shorter side. The texels just
// beyond the diagonal then lie up to that part of a texel's size from where a triangle's own map has them,
// which bilinear lookups blur more than.
constexpr double kMostSkew = 0.25;

struct Edge {
  std::uint32_t low, high;  ///< welded vertices
  std::uint32_t triangle;
  std::uint8_t opposite;  ///< corner

  bool joins(const Edge& other) const { return low == other.low && high == other.high; }
};

struct Pair {
  double cost;  ///< 0 for a rectangle
  SurfaceChart chart;
};

std::array<std::uint8_t, 3> corners_from(unsigned corner) {
  return {std::uint8_t(corner), std::uint8_t((corner + 1) % 3), std::uint8_t((corner + 2) % 3)};
}

std::vector<int> part_of_triangles(const Mesh& mesh) {
  std::vector<int> parts(mesh.triangles.size(), 0);
  for (std::size_t p = 0; p < mesh.parts.size(); ++p)
    std::fill_n(parts.begin() + mesh.parts[p].first_triangle, mesh.parts[p].triangle_count, int(p));
  return parts;
}

bool has_area(const std::array<glm::dvec3, 3>& p) {
  const double longest =
      std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
  const double area = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
  return std::isfinite(area) && longest > 0 && area > kLeastHeight * longest * longest;
}

class ChartFinder {
 public:
  ChartFinder(const Mesh& mesh, const glm::mat4& transform)
      : mesh_(mesh),
        transform_(transform),
        welded_(weld_positions(mesh.positions)),
        parts_(part_of_triangles(mesh)) {}

  std::vector<SurfaceChart> run() {
    std::vector<bool> done(mesh_.triangles.size());
    for (std::uint32_t t = 0; t < done.size(); ++t) done[t] = !has_area(corners(t));
    std::vector<SurfaceChart> charts;
    for (const Pair& pair : pairs(done)) {
      const std::uint32_t a = pair.chart.first.triangle, b = pair.chart.second->triangle;
      if (done[a] || done[b]) continue;
      done[a] = done[b] = true;
      charts.push_back(pair.chart);
    }
    for (std::uint32_t t = 0; t < done.size(); ++t)
      if (!done[t]) charts.push_back(half(t));
    return charts;
  }

 private:
  std::array<glm::dvec3, 3> corners(std::uint32_t triangle) const {
    return world_corners(mesh_, transform_, triangle);
  }
  std::uint32_t vertex(const TriangleHalf& half, std::size_t i) const {
    return mesh_.triangles[half.triangle][half.corners[i]];
  }

  std::vector<Edge> sorted_edges(const std::vector<bool>& left_out) const {
    std::vector<Edge> edges;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (unsigned k = 0; k < 3 && !left_out[t]; ++k) {
        const auto [low, high] = std::minmax(
            {welded_[mesh_.triangles[t][int(k + 1) % 3]], welded_[mesh_.triangles[t][int(k + 2) % 3]]});
        edges.push_back({low, high, t, std::uint8_t(k)});
      }
    std::ranges::sort(edges, {}, [](const Edge& e) { return std::tuple(e.low, e.high, e.triangle); });
    return edges;
  }

  /// All that may become one chart, the best first.
  std::vector<Pair> pairs(const std::vector<bool>& left_out) const {
    const std::vector<Edge> edges = sorted_edges(left_out);
    std::vector<Pair> pairs;
    for (std::size_t i = 1; i < edges.size(); ++i)
      if (edges[i - 1].joins(edges[i]))
        if (const auto pair = join(edges[i - 1], edges[i])) pairs.push_back(*pair);
    std::ranges::sort(pairs, {}, [](const Pair& p) {
      return std::tuple(p.cost, p.chart.first.triangle, p.chart.second->triangle);
    });
    return pairs;
  }

  bool shades_alike(const TriangleHalf& a, const TriangleHalf& b) const {
    if (parts_[a.triangle] != parts_[b.triangle]) return false;
    for (std::size_t i = 1; i < 3; ++i) {  // the ends of the edge, which the two run through in turn
      const std::uint32_t va = vertex(a, i), vb = vertex(b, 3 - i);
      if (welded_[va] != welded_[vb]) return false;
      if (va != vb && glm::dot(mesh_.normals[va], mesh_.normals[vb]) < kSameNormal) return false;
    }
    return true;
  }

  std::optional<Pair> join(const Edge& one, const Edge& other) const {
    const TriangleHalf first{one.triangle, corners_from(one.opposite)};
    const TriangleHalf second{other.triangle, corners_from(other.opposite)};
    if (!shades_alike(first, second)) return std::nullopt;
    const auto p = corners(first.triangle), q = corners(second.triangle);
    const glm::dvec3 origin = p[first.corners[0]], far = q[second.corners[0]];
    const glm::dvec3 u = p[first.corners[1]] - origin, v = p[first.corners[2]] - origin;
    const glm::dvec3 far_u = far - p[first.corners[2]], far_v = far - p[first.corners[1]];
    const double cosine =
        glm::dot(glm::normalize(glm::cross(u, v)), glm::normalize(glm::cross(far_u, far_v)));
    const double skew = glm::length(far_u - u) / std::min(glm::length(u), glm::length(v));
    const double shear = std::abs(glm::dot(glm::normalize(u), glm::normalize(v)));
    if (cosine < kCoplanar || skew > kMostSkew || shear > kMostShear) return std::nullopt;
    return Pair{skew + shear, longer_first({first, second, 0.5 * (glm::length(u) + glm::length(far_u)),
                                            0.5 * (glm::length(v) + glm::length(far_v))})};
  }

  SurfaceChart half(std::uint32_t triangle) const {
    const auto p = corners(triangle);
    const auto opposite_edge = [&](unsigned k) { return glm::distance(p[(k + 1) % 3], p[(k + 2) % 3]); };
    const unsigned right =
        std::max({0u, 1u, 2u}, [&](unsigned i, unsigned j) { return opposite_edge(i) < opposite_edge(j); });
    return longer_first({{triangle, corners_from(right)},
                         std::nullopt,
                         opposite_edge((right + 2) % 3),
                         opposite_edge((right + 1) % 3)});
  }

  static SurfaceChart longer_first(SurfaceChart chart) {
    if (chart.u_length >= chart.v_length) return chart;
    std::swap(chart.u_length, chart.v_length);
    std::swap(chart.first.corners[1], chart.first.corners[2]);
    if (chart.second) std::swap(chart.second->corners[1], chart.second->corners[2]);
    return chart;
  }

  const Mesh& mesh_;
  const glm::mat4& transform_;
  std::vector<std::uint32_t> welded_;
  std::vector<int> parts_;
};

}  // namespace

std::array<glm::dvec3, 3> world_corners(const Mesh& mesh, const glm::mat4& transform,
                                        std::uint32_t triangle) {
  std::array<glm::dvec3, 3> corners;
  for (int i = 0; i < 3; ++i)
    corners[std::size_t(i)] =
        glm::dmat4(transform) * glm::dvec4(mesh.positions[mesh.triangles[triangle][i]], 1);
  return corners;
}

std::vector<SurfaceChart> find_charts(const Mesh& mesh, const glm::mat4& transform) {
  return ChartFinder(mesh, transform).run();
}

}  // namespace lightbench
