#include "scene/smoothing_groups.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace lightbench {
namespace {

// A group at a point.
std::uint64_t key(std::uint32_t point, std::int32_t group) {
  return std::uint64_t(point) << 32 | std::uint32_t(group);
}

glm::dvec3 flat_normal(std::span<const glm::vec3> points, const glm::uvec3& t) {
  const glm::dvec3 a(points[t.x]);
  return glm::normalize(glm::cross(glm::dvec3(points[t.y]) - a, glm::dvec3(points[t.z]) - a));
}

double angle_at(std::span<const glm::vec3> points, const glm::uvec3& t, int corner) {
  const glm::dvec3 p(points[t[corner]]);
  const glm::dvec3 u = glm::normalize(glm::dvec3(points[t[(corner + 1) % 3]]) - p);
  const glm::dvec3 v = glm::normalize(glm::dvec3(points[t[(corner + 2) % 3]]) - p);
  return std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0));
}

}  // namespace

std::vector<glm::vec3> smoothing_group_normals(std::span<const glm::vec3> points,
                                               std::span<const glm::uvec3> triangles,
                                               std::span<const std::int32_t> groups,
                                               const std::vector<bool>& wanted) {
  std::unordered_map<std::uint64_t, glm::dvec3> sums;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (int k = 0; k < 3 && groups[i] > 0; ++k)
      sums[key(triangles[i][k], groups[i])] +=
          angle_at(points, triangles[i], k) * flat_normal(points, triangles[i]);
  std::vector<glm::vec3> normals(3 * triangles.size(), glm::vec3(0));
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      if (!wanted[3 * i + k]) continue;
      const auto sum = sums.find(key(triangles[i][int(k)], groups[i]));
      const double length = sum == sums.end() ? 0 : glm::length(sum->second);
      // The sum of faces that look to opposite sides says nothing.
      const bool is_smooth = length > 1e-6;
      normals[3 * i + k] = glm::vec3(is_smooth ? sum->second / length : flat_normal(points, triangles[i]));
    }
  return normals;
}

}  // namespace lightbench
