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

}  // namespace lightbench::test
