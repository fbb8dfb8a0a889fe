#include <gmock/gmock.h>

#include "pov_test_scenes.h"

namespace lightbench {
namespace {

/// A small square of albedo 0.5 without lights before a background of 0.6.
Scene open_scene(bool background_lights) {
  Scene scene = scene_of(facing_square(), matte(glm::vec3(0.5f)));
  scene.background = {{0.6f, 0.6f, 0.3f}, background_lights};
  return scene;
}

TEST(PovrayBackground, IsGatheredByRadiosity) {
  const Image image = render(open_scene(true), facing_camera(2), {});
  EXPECT_NEAR(image.pixel(16, 16)[0], 0.3f, 0.003f);  // gathering is a mean over 250 rays
  EXPECT_NEAR(image.pixel(16, 16)[2], 0.15f, 0.003f);
}

TEST(PovrayBackground, LightsDarkSurfacesToo) {
  Scene scene = open_scene(true);
  scene.materials[0].diffuse = {0.004f, 0, 0.02f};
  const Image image = render(scene, facing_camera(2), {});
  EXPECT_NEAR(image.pixel(16, 16)[0], 0.0024f, 0.0001f);
  EXPECT_NEAR(image.pixel(16, 16)[2], 0.006f, 0.0001f);
}

TEST(PovrayBackground, MayBeShutOutOfTheLight) {
  const Image image = render(open_scene(false), facing_camera(2), {});
  EXPECT_EQ(image.pixel(16, 16)[0], 0);
  EXPECT_NEAR(image.pixel(0, 0)[0], 0.6f, kHalfError);
}

TEST(PovrayBackground, ShowsWhereNothingIsWithAlphaZero) {
  const Image image = render(open_scene(true), facing_camera(2), {});
  EXPECT_NEAR(image.pixel(0, 0)[0], 0.6f, kHalfError);
  EXPECT_NEAR(image.pixel(0, 0)[2], 0.3f, kHalfError);
  EXPECT_EQ(image.pixel(0, 0)[3], 0);
  EXPECT_EQ(image.pixel(16, 16)[3], 1);
}

TEST(PovrayBackground, EdgesAreMixedWhenSupersampled) {
  Scene scene = open_scene(false);
  const Image image =
      render(scene, facing_camera(2), direct_options(), 6, 6, 4);  // the square spans 1.5 .. 4.5
  EXPECT_EQ(image.pixel(1, 3)[3], 0.5f);
  EXPECT_NEAR(image.pixel(1, 3)[0], 0.3f, kHalfError);
}

TEST(PovrayBackground, IsSeenByRadiosityThroughCutOuts) {
  Scene scene = open_scene(true);
  scene.materials.push_back(matte(glm::vec3(1)));
  scene.materials[1].cutout_texture = 0;
  scene.textures = {{"clear.png", Image8(1, 1, 4, 0)}};
  scene.meshes.push_back(quad_mesh({{-9, -9, 1}, {9, -9, 1}, {9, 9, 1}, {-9, 9, 1}}));
  scene.meshes[1].parts[0].material = 1;
  scene.entities.push_back({"pane", 1, glm::mat4(1)});
  EXPECT_NEAR(render(scene, facing_camera(2), {}).pixel(16, 16)[0], 0.3f, 0.003f);
}

}  // namespace
}  // namespace lightbench
