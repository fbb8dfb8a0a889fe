#include <cmath>

#include <gmock/gmock.h>

#include "pov_test_scenes.h"
#include "scene/emitting_surface.h"

namespace lightbench {
namespace {

/// The facing square of albedo 0.5, seen from just before the plane z = 1, in which the tests put emitters.
Scene dark_scene() {
  return scene_of(facing_square(), matte(glm::vec3(0.5f)));
}

Camera close_camera() {
  Camera camera = facing_camera();
  camera.position.z = 0.9f;
  return camera;
}

float middle_of(const Scene& scene) {
  PovOptions options;
  options.count = 1600;
  options.recursion_limit = 1;
  return render(scene, close_camera(), options).pixel(16, 16)[0];
}

// Gathering is a mean over 1600 directions of fixed places.
constexpr float kGathered = 0.01f;

TEST(PovrayRadiosity, GathersEmissionAsItGathersABackground) {
  Scene scene = dark_scene();
  scene.materials.push_back(matte(glm::vec3(0)));
  scene.materials[1].emission = {0.6f, 0, 0};
  scene.meshes.push_back(quad_mesh({{-99, -99, 1}, {99, -99, 1}, {99, 99, 1}, {-99, 99, 1}}));
  scene.meshes[1].parts[0].material = 1;
  scene.entities.push_back({"sky", 1, glm::mat4(1)});
  EXPECT_NEAR(middle_of(scene), 0.5f * 0.6f, 0.3f * kGathered);
}

TEST(PovrayRadiosity, GathersALambertEmitterByItsFormFactor) {
  Scene scene = dark_scene();
  Light light;
  light.kind = LightKind::area;
  light.position = {0, 0, 1};
  light.edge_u = {2, 0, 0};
  light.edge_v = {0, 2, 0};
  light.power = 2;
  add_emitting_surface(scene, light);
  // From a point to the parallel square of twice its distance, centred above it.
  const float root = std::sqrt(2.0f);
  const float form_factor = 4 / 3.14159265f / root * std::atan(1 / root);
  EXPECT_NEAR(middle_of(scene), 0.5f * 2 * form_factor, 3 * kGathered * form_factor);
}

TEST(PovrayRadiosity, ALambertEmitterShowsItsRadianceOnBothSides) {
  Scene scene = dark_scene();
  Light light;
  light.name = "panel";
  light.kind = LightKind::area;
  light.shape = AreaShape::triangle;
  light.position = {-4, -4, 0.5f};
  light.edge_u = {8, 0, 0};
  light.edge_v = {0, 8, 0};
  light.color = {0.25f, 0.5f, 1};
  light.power = 1.5f;
  add_emitting_surface(scene, light);
  Camera behind = facing_camera();
  behind.position.z = -5;
  for (const Camera& camera : {facing_camera(), behind}) {
    scene.entities[0].transform[3][2] = camera.position.z < 0 ? 1 : 0;  // the square behind the triangle
    const Image image = render(scene, camera);
    EXPECT_NEAR(image.pixel(14, 18)[0], 0.375f, kHalfError);
    EXPECT_NEAR(image.pixel(14, 18)[2], 1.5f, kHalfError);
  }
}

}  // namespace
}  // namespace lightbench
