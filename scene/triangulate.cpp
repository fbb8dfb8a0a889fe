#include "scene/triangulate.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "scene/ear_clipper.h"

namespace lightbench {
namespace {

// Newell's normal: twice the area vector of the polygon, whether it is planar or not.
glm::dvec3 area_vector(std::span<const glm::vec3> polygon) {
  const glm::dvec3 origin(polygon[0]);
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += glm::cross(glm::dvec3(polygon[i]) - origin, glm::dvec3(polygon[i + 1]) - origin);
  return sum;
}

// The sum of what the parts of the polygon have along each axis, whichever way it goes around them.
glm::dvec3 sum_of_sizes(std::span<const glm::vec3> polygon) {
  const glm::dvec3 origin(polygon[0]);
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += glm::abs(glm::cross(glm::dvec3(polygon[i]) - origin, glm::dvec3(polygon[i + 1]) - origin));
  return sum;
}

double largest_of(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

// The corners seen along the largest component of the area vector, turning to the left. The area vector of a
// polygon that goes around two equal parts in opposite ways is zero but for rounding, and says nothing.
std::vector<glm::dvec2> project(std::span<const glm::vec3> polygon) {
  constexpr double kRounding = 1e-9;
  const glm::dvec3 n = area_vector(polygon);
  const glm::dvec3 sizes = sum_of_sizes(polygon);
  const glm::dvec3 size = largest_of(glm::abs(n)) > kRounding * largest_of(sizes) ? glm::abs(n) : sizes;
  const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int u = (drop + 1) % 3;
  const int v = (drop + 2) % 3;
  std::vector<glm::dvec2> flat;
  flat.reserve(polygon.size());
  for (const glm::vec3& p : polygon) flat.emplace_back(p[u], n[drop] >= 0 ? p[v] : -p[v]);
  return flat;
}

// A polygon whose corners all turn to the left may still go around twice: then its fan turns back.
bool is_convex(const std::vector<glm::dvec2>& flat) {
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turn_of(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0 ||
        turn_of(flat[0], flat[i], flat[(i + 1) % n]) < 0)
      return false;
  return true;
}

}  // namespace

bool triangulate(std::span<const glm::vec3> polygon, std::vector<glm::uvec3>& triangles,
                 ClippingBudget& budget) {
  if (polygon.size() > 3) {
    const std::vector<glm::dvec2> flat = project(polygon);
    if (!is_convex(flat)) return EarClipper(flat, triangles, budget).run();
  }
  for (std::uint32_t i = 1; i + 1 < polygon.size(); ++i) triangles.emplace_back(0u, i, i + 1);
  return true;
}

}  // namespace lightbench
