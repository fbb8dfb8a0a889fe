#include "scene/nearest_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

namespace lightbench {
namespace {

Bounds local_bounds(const Mesh& mesh) {
  Bounds bounds;
  for (const glm::vec3& p : mesh.positions) bounds.add(p);
  return bounds;
}

float squared_length(const glm::vec3& v) {
  return glm::dot(v, v);
}

float squared_distance_to_segment(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 ab = b - a;
  const float length2 = squared_length(ab);
  const float t = length2 > 0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0f, 1.0f) : 0.0f;
  return squared_length(p - (a + t * ab));
}

float squared_distance_to_triangle(const glm::vec3& p, const std::array<glm::vec3, 3>& t) {
  const glm::vec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
  const float n2 = squared_length(n);
  const bool above = n2 > 0 && glm::dot(glm::cross(t[1] - t[0], p - t[0]), n) >= 0 &&
                     glm::dot(glm::cross(t[2] - t[1], p - t[1]), n) >= 0 &&
                     glm::dot(glm::cross(t[0] - t[2], p - t[2]), n) >= 0;
  if (above) {
    const float height = glm::dot(p - t[0], n);
    return height * height / n2;
  }
  return std::min({squared_distance_to_segment(p, t[0], t[1]), squared_distance_to_segment(p, t[1], t[2]),
                   squared_distance_to_segment(p, t[2], t[0])});
}

float squared_distance_to_box(const glm::vec3& p, const glm::vec3& min, const glm::vec3& max) {
  return squared_length(p - glm::clamp(p, min, max));
}

// Lowers `best` to the squared distance of the entity's nearest triangle.
void approach(const Mesh& mesh, const glm::mat4& transform, const glm::vec3& p, float& best) {
  Bounds box;
  for (const glm::vec3& corner : corners(local_bounds(mesh))) box.add(transform_point(transform, corner));
  if (squared_distance_to_box(p, box.min, box.max) >= best) return;
  std::vector<glm::vec3> world(mesh.positions.size());
  std::transform(mesh.positions.begin(), mesh.positions.end(), world.begin(),
                 [&](const glm::vec3& q) { return transform_point(transform, q); });
  for (const glm::uvec3& triangle : mesh.triangles) {
    const std::array<glm::vec3, 3> t{world[triangle.x], world[triangle.y], world[triangle.z]};
    const glm::vec3 min = glm::min(glm::min(t[0], t[1]), t[2]);
    const glm::vec3 max = glm::max(glm::max(t[0], t[1]), t[2]);
    if (squared_distance_to_box(p, min, max) >= best) continue;
    best = std::min(best, squared_distance_to_triangle(p, t));
  }
}

}  // namespace

float distance_to_nearest_surface(const Scene& scene, const glm::vec3& p) {
  float best = std::numeric_limits<float>::infinity();
  for (const Entity& entity : scene.entities)
    approach(scene.meshes[std::size_t(entity.mesh)], entity.transform, p, best);
  return std::sqrt(best);
}

namespace {

constexpr std::size_t kGroupSize = 64;

std::array<glm::vec3, 3> world_triangle(const Scene& scene, const Entity& entity, std::size_t index) {
  const Mesh& mesh = scene.meshes[std::size_t(entity.mesh)];
  const glm::uvec3& t = mesh.triangles[index];
  return {transform_point(entity.transform, mesh.positions[t.x]),
          transform_point(entity.transform, mesh.positions[t.y]),
          transform_point(entity.transform, mesh.positions[t.z])};
}

}  // namespace

NearestSurface::NearestSurface(const Scene& scene) : scene_(scene) {
  for (std::size_t e = 0; e < scene.entities.size(); ++e) {
    const std::size_t count = scene.meshes[std::size_t(scene.entities[e].mesh)].triangles.size();
    for (std::size_t first = 0; first < count; first += kGroupSize) {
      Group& group = groups_.emplace_back(Group{e, first, std::min(first + kGroupSize, count), {}});
      for (std::size_t i = first; i < group.end; ++i)
        for (const glm::vec3& corner : world_triangle(scene, scene.entities[e], i)) group.box.add(corner);
    }
  }
}

float NearestSurface::distance(const glm::vec3& p, float limit) const {
  const float farthest = limit * limit;
  float best = farthest;
  for (const Group& group : groups_) {
    if (squared_distance_to_box(p, group.box.min, group.box.max) >= best) continue;
    for (std::size_t i = group.first; i < group.end; ++i)
      best = std::min(
          best, squared_distance_to_triangle(p, world_triangle(scene_, scene_.entities[group.entity], i)));
  }
  return best < farthest ? std::min(std::sqrt(best), limit) : limit;
}

std::vector<glm::vec3> corners(const Bounds& b) {
  std::vector<glm::vec3> result;
  for (unsigned i = 0; i < 8; ++i)
    result.emplace_back(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z);
  return result;
}

glm::vec3 transform_point(const glm::mat4& transform, const glm::vec3& p) {
  return glm::vec3(transform * glm::vec4(p, 1.0f));
}

}  // namespace lightbench
