#pragma once

#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "base/files.h"
#include "base/image_io.h"
#include "povexport/pov_scene.h"
#include "povexport/povray.h"
#include "scene/scene.h"

namespace lightbench {

inline Material matte(const glm::vec3& diffuse) {
  Material material;
  material.diffuse = diffuse;
  return material;
}

/// A quad through four corners; uv runs from (0,0) at the first to (1,1) at the third, times `repeat`.
inline Mesh quad_mesh(const std::vector<glm::vec3>& corners, float repeat = 1) {
  Mesh mesh;
  mesh.positions = corners;
  mesh.normals.assign(4, glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
  mesh.uvs = {{0, 0}, {repeat, 0}, {repeat, repeat}, {0, repeat}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.parts = {{0, 0, 2}};
  return mesh;
}

/// The square -1..1 in the plane z = 0, facing +z, seen by `facing_camera` so that it fills the image.
inline Mesh facing_square(float repeat = 1) {
  return quad_mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, repeat);
}

inline Camera facing_camera(float half_height = 1) {
  return {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 2 * std::atan(half_height / 5)};
}

inline Scene scene_of(Mesh mesh, const Material& material = matte(glm::vec3(1))) {
  Scene scene;
  scene.name = "test";
  scene.materials = {material};
  scene.meshes = {std::move(mesh)};
  scene.entities = {{"object", 0, glm::mat4(1)}};
  return scene;
}

inline Light frontal_light() {
  Light light;
  light.kind = LightKind::directional;
  light.direction = {0, 0, -1};
  return light;
}

inline PovOptions direct_options() {
  PovOptions options;
  options.radiosity = false;
  return options;
}

inline PovrayImage render_text(const std::string& text, const Scene& scene, const PovAssets& assets,
                               int width, int height, int samples = 1) {
  const TemporaryFolder folder("pov-test");
  for (const auto& [name, include] : assets.includes)
    write_file_atomic(folder.path() / "lib" / name, include);
  for (const auto& [name, image] : assets.images)
    write_png(folder.path() / "lib" / name, pov_image(scene, image));
  write_file_atomic(folder.path() / "view.pov", text);
  std::filesystem::create_directories(folder.path() / "lib");
  PovrayRun run;
  run.program = find_povray();
  run.scene_file = folder.path() / "view.pov";
  run.library = folder.path() / "lib";
  run.width = width;
  run.height = height;
  run.samples = samples;
  run.timeout = std::chrono::minutes(5);
  return run_povray(run);
}

inline Image render(const Scene& scene, const Camera& camera, const PovOptions& options = direct_options(),
                    int width = 32, int height = 32, int samples = 1) {
  const PovAssets assets = pov_assets(scene);
  const std::string text = pov_view(scene, assets, camera, double(width) / height, options);
  return render_text(text, scene, assets, width, height, samples).image;
}

/// What a half float can lose of a value below 2.
inline constexpr float kHalfError = 0.001f;

}  // namespace lightbench
