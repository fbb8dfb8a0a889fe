#pragma once

#include "scene/box_mesh.h"
#include "tests/renderer/render_scene.h"

/// Closed rooms, seen from inside.
namespace lightbench::test {

/// A closed box of 4 x 4 x 4 around the origin, of one material, and a view in it.
inline Scene box_scene(const Material& material) {
  Scene scene;
  scene.name = "box";
  scene.materials = {material};
  scene.meshes = {box_mesh("box", {glm::vec3(-2), glm::vec3(2)}, 0)};
  scene.entities = {{"box", 0, glm::mat4(1)}};
  return scene;
}
inline View inside_view() {
  View view;
  view.name = "inside";
  view.camera.position = {1.2f, 0.9f, 1.5f};
  view.camera.look_at = {-1, -0.4f, -1};
  view.camera.fov = 1.2f;
  return view;
}

/// A room with a coloured wall, a block and a small lamp; lit from all bounces.
inline Scene room() {
  Scene scene = box_scene(matte(glm::vec3(0.6f)));
  scene.materials.push_back(matte({0.8f, 0.2f, 0.1f}));
  add_quad(scene, {-1.99f, -2, -2}, {0, 0, 4}, {0, 4, 0}, 1);
  scene.meshes.push_back(box_mesh("block", {{-1.2f, -2, -1.2f}, {-0.2f, -0.8f, -0.2f}}, 0));
  scene.entities.push_back({"block", int(scene.meshes.size()) - 1, glm::mat4(1)});
  scene.lights = {point_light({0.4f, 1.5f, 0.3f})};
  scene.lights[0].power = 0.5f;
  return scene;
}

}  // namespace lightbench::test
