#include "renderer/radiance/lids.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace lightbench {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

constexpr float kFlat = 1e-3f;      // of a rim's size: how far it may leave its plane
constexpr float kTouching = 5e-3f;  // of a rim's size: how far what it stands on may be from it
constexpr int kSteps = 6;           // of a triangle's edge, between which points are looked at

float size_of(const std::vector<glm::vec3>& rim) {
  Bounds bounds;
  for (const glm::vec3& p : rim) bounds.add(p);
  return bounds.diagonal();
}

glm::vec3 middle_of(const std::vector<glm::vec3>& rim) {
  glm::vec3 sum(0);
  for (const glm::vec3& p : rim) sum += p;
  return sum / float(rim.size());
}

/// Twice the area, along the normal (Newell's method).
glm::vec3 area_of(const std::vector<glm::vec3>& rim, const glm::vec3& middle) {
  glm::vec3 area(0);
  for (std::size_t i = 0; i < rim.size(); ++i)
    area += glm::cross(rim[i] - middle, rim[(i + 1) % rim.size()] - middle);
  return area;
}

bool touches(const SceneRays& scene, const glm::vec3& point, const glm::vec3& normal, float reach) {
  const glm::vec3 way = reach * normal;
  return scene.occluded(point - way, point + way);
}

}  // namespace

std::optional<std::vector<std::vector<std::uint32_t>>> open_rims(const Triangles& triangles) {
  std::vector<Edge> forward, backward;
  for (const glm::uvec3& t : triangles)
    for (const auto& [a, b] : {Edge(t.x, t.y), Edge(t.y, t.z), Edge(t.z, t.x)}) {
      forward.emplace_back(a, b);
      backward.emplace_back(b, a);
    }
  std::ranges::sort(forward);
  std::ranges::sort(backward);
  if (std::ranges::adjacent_find(forward) != forward.end()) return std::nullopt;
  std::vector<Edge> open;
  std::ranges::set_difference(backward, forward, std::back_inserter(open));
  std::multimap<std::uint32_t, std::uint32_t> next(open.begin(), open.end());
  std::vector<std::vector<std::uint32_t>> rims;
  while (!next.empty()) {
    // As many open edges end at a vertex as begin there, so that each chain comes back to its first vertex.
    std::vector<std::uint32_t> rim;
    for (auto edge = next.begin(); edge != next.end(); edge = next.find(rim.back())) {
      if (rim.empty()) rim.push_back(edge->first);
      rim.push_back(edge->second);
      next.erase(edge);
      if (rim.back() == rim.front()) break;
    }
    rim.pop_back();
    rims.push_back(std::move(rim));
  }
  return rims;
}

std::optional<std::vector<glm::vec3>> lid_of(const std::vector<glm::vec3>& rim, const SceneRays& scene) {
  const float size = size_of(rim);
  const glm::vec3 middle = middle_of(rim), area = area_of(rim, middle);
  std::vector<glm::vec3> lid;
  for (std::size_t i = 0; i < rim.size(); ++i)
    lid.insert(lid.end(), {middle, rim[i], rim[(i + 1) % rim.size()]});
  if (glm::length(area) <= kFlat * size * size) return lid;  // a crack
  const glm::vec3 normal = glm::normalize(area);
  for (const glm::vec3& p : rim)
    if (std::abs(glm::dot(p - middle, normal)) > kFlat * size) return std::nullopt;
  for (std::size_t i = 0; i < lid.size(); i += 3)
    for (int a = 0; a < kSteps; ++a)
      for (int b = 0; a + b < kSteps; ++b) {
        const float s = (float(a) + 1.0f / 3) / kSteps, t = (float(b) + 1.0f / 3) / kSteps;
        const glm::vec3 point = lid[i] + s * (lid[i + 1] - lid[i]) + t * (lid[i + 2] - lid[i]);
        if (!touches(scene, point, normal, kTouching * size)) return std::nullopt;
      }
  return lid;
}

}  // namespace lightbench
