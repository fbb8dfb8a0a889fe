#pragma once

#include <cmath>

#include "scene/water.h"
#include "tests/renderer/caustics/water_scenes.h"

namespace lightbench::test {

/// Light from straight above enters water whose level is a plane that rises along x by half a unit for each:
/// below it all rays run along one direction, which is not that below flat water and so not a box's axis.
/// There is no floor.
inline Scene tilted_water_scene() {
  Scene scene = pool_scene({0, -1, 0});
  scene.entities.clear();
  scene.meshes.clear();
  // So long a wave is a plane over the pool.
  const float length = 1e5f;
  scene.water->waves = {{0.5f * length / 6.28318531f, length, {1, 0}, 0, 0}};
  scene.water->height = 4;
  return scene;
}

/// Returns by how much those rays move along x for each unit that they fall: Snell's law at the plane, whose
/// normal is atan(0.5) off the light.
inline double tilted_water_step(const Scene& scene) {
  const double before = std::atan(0.5), after = std::asin(std::sin(before) / double(scene.water->ior));
  return std::tan(before - after);
}

/// Returns what of a light of 1 then passes through each unit of level area. Two rays that enter a unit apart along
/// x enter half a unit of height apart, so that below both they are farther apart by what one of them moves
/// over that fall.
inline double tilted_water_flux(const Scene& scene) {
  return 1 / (1 + 0.5 * tilted_water_step(scene));
}

/// Adds a rectangle as an entity of its own, of the first material, with its front upwards: from (-0.5, 0) to
/// (0.5, rise) along x and y, and as far along z.
inline void add_ramp(Scene& scene, float rise) {
  Mesh mesh;
  mesh.name = "ramp";
  mesh.positions = {{-0.5f, 0, -0.5f}, {-0.5f, 0, 0.5f}, {0.5f, rise, 0.5f}, {0.5f, rise, -0.5f}};
  mesh.normals.assign(4, glm::normalize(glm::vec3(-rise, 1, 0)));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.parts = {{0, 0, 2}};
  scene.meshes.push_back(mesh);
  scene.entities.push_back({"ramp", int(scene.meshes.size()) - 1});
}

}  // namespace lightbench::test
