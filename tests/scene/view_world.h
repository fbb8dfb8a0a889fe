#pragma once

#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "scene/box_mesh.h"
#include "scene/random_views.h"

/// Small worlds of boxes, and exact rays against them.
namespace lightbench::test {

inline constexpr float kAspect = 4.0f / 3.0f;

enum class Facing { outward, inward };

class TestWorld {
 public:
  TestWorld() { scene_.materials.emplace_back(); }

  TestWorld& add(const glm::vec3& min, const glm::vec3& max, Facing facing) {
    Bounds box;
    box.add(min);
    box.add(max);
    Mesh mesh = box_mesh("box", box, 0);
    if (facing == Facing::inward)
      for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    scene_.meshes.push_back(std::move(mesh));
    scene_.entities.push_back({"box", int(scene_.meshes.size()) - 1, glm::mat4(1)});
    return *this;
  }

  TestWorld& add_quad(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
    Mesh mesh;
    mesh.positions = {corner, corner + u, corner + u + v, corner + v};
    mesh.normals.assign(4, glm::normalize(glm::cross(u, v)));
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.parts = {{0, 0, 2}};
    scene_.meshes.push_back(std::move(mesh));
    scene_.entities.push_back({"quad", int(scene_.meshes.size()) - 1, glm::mat4(1)});
    return *this;
  }

  TestWorld& add_light(const glm::vec3& position) {
    Light light;
    light.position = position;
    scene_.lights.push_back(light);
    return *this;
  }

  TestWorld& add_sun(const glm::vec3& direction) {
    Light light;
    light.kind = LightKind::directional;
    light.direction = glm::normalize(direction);
    scene_.lights.push_back(light);
    return *this;
  }

  Scene& scene() { return scene_; }
  const Scene& scene() const { return scene_; }
  ClosestHit rays() const {
    return [this](const glm::vec3& origin, const glm::vec3& direction) { return trace(origin, direction); };
  }

 private:
  std::optional<RayHit> trace(const glm::vec3& origin, const glm::vec3& direction) const {
    std::optional<RayHit> closest;
    for (const Mesh& mesh : scene_.meshes)
      for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 a = mesh.positions[t.x];
        const glm::vec3 ab = mesh.positions[t.y] - a;
        const glm::vec3 ac = mesh.positions[t.z] - a;
        const glm::vec3 p = glm::cross(direction, ac);
        const float det = glm::dot(ab, p);
        if (std::abs(det) < 1e-12f) continue;
        const float u = glm::dot(origin - a, p) / det;
        const glm::vec3 q = glm::cross(origin - a, ab);
        const float v = glm::dot(direction, q) / det;
        const float distance = glm::dot(ac, q) / det;
        if (u < 0 || v < 0 || u + v > 1 || distance <= 0) continue;
        if (!closest || distance < closest->distance)
          closest = RayHit{distance, glm::normalize(glm::cross(ab, ac))};
      }
    return closest;
  }

  Scene scene_;
};

// A room of 6 x 3 x 5 with three solid boxes in it.
inline TestWorld furnished_room(Facing room = Facing::inward, Facing furniture = Facing::outward) {
  TestWorld world;
  world.add({-3, 0, -2.5f}, {3, 3, 2.5f}, room)
      .add({-2, 0, -2}, {-1, 1, 0}, furniture)
      .add({1, 0, 0.5f}, {2, 2, 1.5f}, furniture)
      .add({0.5f, 0, -2}, {2.5f, 0.8f, -1}, furniture);
  return world;
}

inline RandomViewOptions draw(int count, std::uint64_t seed, int version = kNewestGenerator) {
  RandomViewOptions options;
  options.count = count;
  options.seed = seed;
  options.version = version;
  return options;
}

inline std::string why(const TestWorld& world, const glm::vec3& position, const glm::vec3& look_at,
                       int version) {
  View view{"v", {}};
  view.camera.position = position;
  view.camera.look_at = look_at;
  return why_view_is_invalid(world.scene(), view, kAspect, world.rays(), version).value_or("valid");
}

}  // namespace lightbench::test
