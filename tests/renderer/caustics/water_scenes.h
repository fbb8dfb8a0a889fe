#pragma once

#include "scene/box_mesh.h"
#include "scene/scene.h"
#include "tests/renderer/render_scene.h"

namespace lightbench::test {

/// Adds a box as an entity of its own, of the first material.
inline void add_box(Scene& scene, const std::string& name, const Bounds& box) {
  scene.meshes.push_back(box_mesh(name, box, 0));
  scene.entities.push_back({name, int(scene.meshes.size()) - 1});
}

/// Adds a ball of 64 x 32 quads as an entity of its own, of the first material.
inline void add_sphere(Scene& scene, const std::string& name, const glm::vec3& center, float radius) {
  Mesh mesh;
  mesh.name = name;
  constexpr int kAround = 64, kUp = 32;
  for (int j = 0; j <= kUp; ++j)
    for (int i = 0; i <= kAround; ++i) {
      const float phi = 6.2831853f * float(i) / kAround, theta = 3.14159265f * float(j) / kUp;
      const glm::vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
      mesh.positions.push_back(center + radius * n);
      mesh.normals.push_back(n);
    }
  for (int j = 0; j < kUp; ++j)
    for (int i = 0; i < kAround; ++i) {
      const auto a = std::uint32_t(j * (kAround + 1) + i), b = a + kAround + 1;
      mesh.triangles.emplace_back(a, a + 1, b);
      mesh.triangles.emplace_back(a + 1, b + 1, b);
    }
  mesh.parts = {{0, 0, std::uint32_t(mesh.triangles.size())}};
  scene.meshes.push_back(mesh);
  scene.entities.push_back({name, int(scene.meshes.size()) - 1});
}

/// A white floor at y = 0 from -4 to 4, under flat water at y = 2 from -2 to 2, in the sun.
inline Scene pool_scene(const glm::vec3& direction) {
  Scene scene;
  scene.name = "pool";
  scene.materials.emplace_back();
  add_box(scene, "floor", {{-4, -1, -4}, {4, 0, 4}});
  Water water;
  water.min = {-2, -2};
  water.max = {2, 2};
  water.height = 2;
  water.grid = {9, 9};
  scene.water = water;
  scene.lights = {directional_light(direction)};
  return scene;
}

/// A sphere of radius 1 about (0, 1, 0) in waves that focus on it.
inline Scene sphere_in_waves() {
  Scene scene = pool_scene({0.4f, -2, 0.3f});
  scene.water->height = 3;
  scene.water->grid = {71, 71};
  scene.water->waves = {{0.03f, 1.1f, {0.6f, 0.8f}, 0, 0}, {0.025f, 0.8f, {-0.8f, 0.6f}, 0, 1}};
  add_sphere(scene, "ball", {0, 1, 0}, 1);
  return scene;
}

/// A ball on the floor below fine waves, whose strength at the depth of its middle is 1.2.
inline Scene ball_in_waves() {
  Scene scene = pool_scene({0.25f, -1, 0.15f});
  scene.water->height = 1.6f;
  scene.water->grid = {201, 201};
  scene.water->waves = {{0.02f, 0.9f, {0.8f, 0.6f}, 0, 0},
                        {0.011f, 0.65f, {-0.5f, 0.866f}, 0, 1},
                        {0.0065f, 0.5f, {0.97f, -0.24f}, 0, 2},
                        {0.0043f, 0.42f, {0.2f, 0.98f}, 0, 5}};
  add_sphere(scene, "ball", {0, 0.5f, 0}, 0.5f);
  return scene;
}

/// From five units away on it, so many degrees above the horizon.
inline View looking_down(double degrees) {
  const double angle = degrees * 3.14159265358979 / 180;
  View view;
  view.name = "down";
  view.camera.position =
      glm::vec3(glm::dvec3(0.3, 1, 0) + 5.0 * glm::dvec3(0, std::sin(angle), std::cos(angle)));
  view.camera.look_at = {0, 1, 0};
  view.camera.up = degrees > 80 ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
  view.camera.fov = 0.4f;
  return view;
}

}  // namespace lightbench::test
