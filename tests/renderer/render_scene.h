#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <glm/glm.hpp>

#include "renderer/renderer.h"
#include "scene/scene.h"

/// Small scenes built in code, and one call that renders them.
namespace lightbench::test {

/// A quad p, p + u, p + u + v, p + v as an entity of its own, with uv 0..1 along u and v and the normal u x
/// v.
inline void add_quad(Scene& scene, const glm::vec3& p, const glm::vec3& u, const glm::vec3& v,
                     int material = 0) {
  Mesh mesh;
  mesh.positions = {p, p + u, p + u + v, p + v};
  mesh.normals.assign(4, glm::normalize(glm::cross(u, v)));
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.parts = {{material, 0, 2}};
  scene.entities.push_back({"quad", int(scene.meshes.size()), glm::mat4(1)});
  scene.meshes.push_back(mesh);
}

inline Material matte(const glm::vec3& diffuse) {
  Material material;
  material.diffuse = diffuse;
  return material;
}

/// A floor of albedo 0.5 at y = 0, 20 x 20 units around the origin, and no light.
inline Scene floor_scene() {
  Scene scene;
  scene.name = "floor";
  scene.materials = {matte(glm::vec3(0.5f))};
  add_quad(scene, {-10, 0, 10}, {20, 0, 0}, {0, 0, -20});
  return scene;
}

inline Light point_light(const glm::vec3& position) {
  Light light;
  light.name = "lamp";
  light.position = position;
  return light;
}

inline Light directional_light(const glm::vec3& direction) {
  Light light;
  light.name = "sun";
  light.kind = LightKind::directional;
  light.direction = glm::normalize(direction);
  return light;
}

/// From `height` above the origin straight down, with -z up in the picture.
inline View top_view(float height) {
  View view;
  view.name = "top";
  view.camera.position = {0, height, 0};
  view.camera.look_at = {0, 0, 0};
  view.camera.up = {0, 0, -1};
  view.camera.fov = 1.0f;
  return view;
}

/// Where the centre of a pixel of a top view meets the floor.
inline glm::vec3 floor_point(const View& view, int width, int height, int x, int y) {
  const float half = std::tan(view.camera.fov / 2) * view.camera.position.y;
  const float across = (2 * (float(x) + 0.5f) / float(width) - 1) * half * float(width) / float(height);
  return {across, 0, (2 * (float(y) + 0.5f) / float(height) - 1) * half};
}

struct RenderSetup {
  std::string technique = "direct";
  std::map<std::string, ParamValue> params = {};
  int width = 64;
  int height = 48;
  int samples = 1;
  long long shadow_size = 256;
  std::set<std::string> buffers = {};
  GlBackend backend = GlBackend::osmesa;
};

inline FrameResult render(const Scene& scene, const View& view, const RenderSetup& setup = {}) {
  Renderer renderer(setup.backend);
  const Technique& technique = find_technique(setup.technique, "test");
  std::map<std::string, ParamValue> given = setup.params;
  // Small maps are made faster.
  for (const char* size : {"shadow_size", "directional_shadow_size"})
    if (std::any_of(technique.params.begin(), technique.params.end(),
                    [&](const ParamSpec& p) { return p.name == size; }))
      given.try_emplace(size, setup.shadow_size);
  const ParamValues params = resolve_params(technique.params, technique.presets, "", given, "test");
  return renderer.render(technique, params,
                         {scene, view, setup.width, setup.height, setup.samples, setup.buffers});
}

}  // namespace lightbench::test
