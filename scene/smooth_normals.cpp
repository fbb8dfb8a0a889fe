#include "scene/smooth_normals.h"

#include <cmath>
#include <cstdint>
#include <numeric>

#include <glm/geometric.hpp>

namespace lightbench {
namespace {

// Where more triangles than this meet in a point, their number squared would take too long: such a point is a
// spike or a broken file, and gets flat normals.
constexpr std::size_t kMostTrianglesAtPoint = 2048;

// Faces at exactly the crease angle belong together in spite of rounding.
constexpr float kCosineSlack = 1e-4f;

// The triangles around each point, in their order.
struct Adjacency {
  std::vector<std::uint32_t> first;  // of each point, and the end
  std::vector<std::uint32_t> triangles;

  std::span<const std::uint32_t> around(std::uint32_t point) const {
    return {triangles.data() + first[point], triangles.data() + first[point + 1]};
  }
};

Adjacency adjacency(std::size_t point_count, std::span<const glm::uvec3> triangles) {
  Adjacency result;
  result.first.assign(point_count + 1, 0);
  for (const glm::uvec3& t : triangles)
    for (int k = 0; k < 3; ++k) ++result.first[t[k] + 1];
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.triangles.resize(result.first.back());
  std::vector<std::uint32_t> next(result.first.begin(), result.first.end() - 1);
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) result.triangles[next[triangles[i][k]]++] = i;
  return result;
}

}  // namespace

std::vector<glm::vec3> smooth_normals(std::span<const glm::vec3> points,
                                      std::span<const glm::uvec3> triangles, float crease_angle,
                                      const std::vector<bool>& wanted) {
  std::vector<glm::vec3> areas(triangles.size());
  std::vector<glm::vec3> flat(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const glm::dvec3 a(points[triangles[i].x]);
    const glm::dvec3 area =
        glm::cross(glm::dvec3(points[triangles[i].y]) - a, glm::dvec3(points[triangles[i].z]) - a);
    flat[i] = glm::vec3(glm::normalize(area));
    areas[i] = glm::vec3(area);
  }
  const Adjacency adjacent = adjacency(points.size(), triangles);
  const float limit = std::cos(crease_angle) - kCosineSlack;
  std::vector<glm::vec3> normals(3 * triangles.size(), glm::vec3(0));
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      if (!wanted[3 * i + k]) continue;
      const auto around = adjacent.around(triangles[i][int(k)]);
      glm::dvec3 sum(0);
      if (around.size() <= kMostTrianglesAtPoint)
        for (const std::uint32_t j : around)
          if (glm::dot(flat[i], flat[j]) >= limit) sum += glm::dvec3(areas[j]);
      const double length = glm::length(sum);
      normals[3 * i + k] = length > 0 ? glm::vec3(sum / length) : flat[i];
    }
  return normals;
}

}  // namespace lightbench
