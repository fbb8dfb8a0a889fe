#include "scene/triangulate.h"

#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace lightbench {
namespace {

// Clipping ears takes time in the square of the corners: beyond this a polygon is taken as convex.
constexpr std::size_t kMostCornersToClip = 4096;

double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Newell's normal: twice the area vector of the polygon, whether it is planar or not.
glm::dvec3 area_vector(std::span<const glm::vec3> polygon) {
  const glm::dvec3 origin(polygon[0]);
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += glm::cross(glm::dvec3(polygon[i]) - origin, glm::dvec3(polygon[i + 1]) - origin);
  return sum;
}

// The corners seen along the largest component of the area vector, turning to the left.
std::vector<glm::dvec2> project(std::span<const glm::vec3> polygon) {
  const glm::dvec3 n = area_vector(polygon);
  const glm::dvec3 size = glm::abs(n);
  const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int u = (drop + 1) % 3;
  const int v = (drop + 2) % 3;
  std::vector<glm::dvec2> flat;
  flat.reserve(polygon.size());
  for (const glm::vec3& p : polygon) flat.emplace_back(p[u], n[drop] >= 0 ? p[v] : -p[v]);
  return flat;
}

bool is_convex(const std::vector<glm::dvec2>& flat) {
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i)
    if (cross(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) < 0) return false;
  return true;
}

bool inside(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  if (p == a || p == b || p == c) return false;
  return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
}

class EarClipper {
 public:
  EarClipper(const std::vector<glm::dvec2>& flat, std::vector<glm::uvec3>& triangles)
      : flat_(flat), triangles_(triangles), left_(flat.size()) {
    std::iota(left_.begin(), left_.end(), 0u);
  }

  void run() {
    while (left_.size() > 3) clip(best_ear());
    triangles_.emplace_back(left_[0], left_[1], left_[2]);
  }

 private:
  std::uint32_t before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
  std::uint32_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }
  double turn(std::size_t i) const { return cross(flat_[before(i)], flat_[left_[i]], flat_[after(i)]); }

  bool is_empty(std::size_t i) const {
    const glm::dvec2& a = flat_[before(i)];
    const glm::dvec2& b = flat_[left_[i]];
    const glm::dvec2& c = flat_[after(i)];
    for (std::size_t k = 0; k < left_.size(); ++k)
      if (turn(k) <= 0 && inside(flat_[left_[k]], a, b, c)) return false;
    return true;
  }

  // The first true ear; else, of a polygon that crosses itself or has no area left, the flattest corner.
  std::size_t best_ear() const {
    std::size_t flattest = 0;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (turn(i) > 0 && is_empty(i)) return i;
      if (std::abs(turn(i)) < std::abs(turn(flattest))) flattest = i;
    }
    return flattest;
  }

  void clip(std::size_t i) {
    triangles_.emplace_back(before(i), left_[i], after(i));
    left_.erase(left_.begin() + std::ptrdiff_t(i));
  }

  const std::vector<glm::dvec2>& flat_;
  std::vector<glm::uvec3>& triangles_;
  std::vector<std::uint32_t> left_;
};

}  // namespace

void triangulate(std::span<const glm::vec3> polygon, std::vector<glm::uvec3>& triangles) {
  if (polygon.size() > 3 && polygon.size() <= kMostCornersToClip) {
    const std::vector<glm::dvec2> flat = project(polygon);
    if (!is_convex(flat)) return EarClipper(flat, triangles).run();
  }
  for (std::uint32_t i = 1; i + 1 < polygon.size(); ++i) triangles.emplace_back(0u, i, i + 1);
}

}  // namespace lightbench
