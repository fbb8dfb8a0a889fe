#include "povexport/pov_scene.h"

#include <cstdlib>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"
#include "pov_test_scenes.h"
#include "povexport/pov_lights.h"
#include "scene/motion.h"

namespace lightbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string all_text(const Scene& scene) {
  const PovAssets assets = pov_assets(scene);
  std::string text = pov_view(scene, assets, facing_camera(), 1, {});
  for (const auto& [name, include] : assets.includes) text += "== " + name + "\n" + include;
  for (const auto& [name, image] : assets.images) text += "== " + name + "\n";
  return text;
}

Scene golden_scene() {
  Scene scene = scene_of(facing_square(2), matte({0.5f, 0.25f, 1}));
  scene.textures = {{"a.png", Image8(1, 1, 4, 200)}};
  scene.materials[0].diffuse_texture = 0;
  scene.materials[0].specular = 0.5f;
  scene.materials[0].exponent = 20;
  scene.materials.push_back(matte(glm::vec3(0.75f)));
  scene.materials[1].emission = {0, 1, 2};
  scene.materials[1].cutout_texture = 0;
  scene.meshes[0].parts = {{0, 0, 1}, {1, 1, 1}};
  scene.meshes[0].normals[3] = {0, 1, 0};
  scene.entities[0].transform = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3));
  scene.background.color = {0.1f, 0.2f, 0.3f};
  scene.lights = {frontal_light()};
  return scene;
}

TEST(PovScene, TextIsTheApprovedOne) {
  const std::filesystem::path approved = LIGHTBENCH_TEST_DATA "/povexport/golden.txt";
  if (std::getenv("LIGHTBENCH_APPROVE") != nullptr) write_file_atomic(approved, all_text(golden_scene()));
  EXPECT_EQ(all_text(golden_scene()), read_file(approved)) << "LIGHTBENCH_APPROVE=1 accepts the new text";
}

/// The golden scene with an entity more, which moves.
Scene moving_scene() {
  Scene scene = golden_scene();
  scene.entities.push_back(
      {.name = "mover", .motion = {.keys = {{.time = 0}, {.time = 2, .translate = {8, 0, 0}}}}});
  return scene;
}

TEST(PovScene, WhatMovesStandsInTheViewAndNotInWhatViewsShare) {
  Scene scene = moving_scene();
  const PovAssets assets = pov_assets(scene);
  const std::string at_rest = pov_view(scene, assets, facing_camera(), 1, {});
  set_time(scene, 1);
  EXPECT_EQ(pov_assets(scene).includes, assets.includes) << "at any time";
  const std::string moved = pov_view(scene, assets, facing_camera(), 1, {});
  EXPECT_NE(moved, at_rest);
  const std::size_t end = at_rest.find("object{M1}");
  ASSERT_NE(end, std::string::npos);
  EXPECT_EQ(moved.substr(0, end), at_rest.substr(0, end)) << "camera and lights stay";
  EXPECT_THAT(moved.substr(end), testing::StartsWith("object{M1 matrix<1,0,0,0,1,0,0,0,1,"));
}

TEST(PovScene, WithoutKeyframesTheViewPlacesNothing) {
  const PovAssets assets = pov_assets(golden_scene());
  EXPECT_THAT(pov_view(golden_scene(), assets, facing_camera(), 1, {}), testing::Not(HasSubstr("object")));
}

TEST(PovrayMotion, AMovedEntityIsDrawnAsIfItsTransformWereBaked) {
  Scene scene = scene_of(facing_square());
  scene.lights = {frontal_light()};
  scene.entities[0].motion.keys = {{.time = 0, .rotate = {0, 0, 30}}, {.time = 2, .translate = {1, 0, 0}}};
  set_time(scene, 1);
  Scene baked = scene;
  baked.entities[0].motion = {};
  const Image moved = render(scene, facing_camera());
  EXPECT_EQ(moved, render(baked, facing_camera()));
  set_time(scene, 0);
  EXPECT_NE(moved, render(scene, facing_camera()));
}

TEST(PovScene, NamesNeverReachTheText) {
  const auto hostile =
      rc::gen::element<std::string>("\"", "\n#include \"x\"", "*/", "//", "}", "<1,2>", "\\", "${A}");
  rc::check([&] {
    Scene scene = golden_scene();
    const std::string clean = all_text(scene);
    const std::string name = *rc::gen::container<std::string>(rc::gen::arbitrary<char>()) + *hostile;
    scene.name = scene.materials[0].name = scene.meshes[0].name = scene.entities[0].name = name;
    scene.lights[0].name = name;
    scene.textures[0].file = name;
    RC_ASSERT(all_text(scene) == clean);
  });
}

TEST(PovScene, ASceneWithoutTrianglesIsAnError) {
  Scene scene = golden_scene();
  scene.entities.clear();
  EXPECT_THROW(pov_assets(scene), Error);
}

TEST(PovScene, ACoordinateThatIsNotFiniteIsAnError) {
  Scene scene = golden_scene();
  scene.meshes[0].positions[0].x = std::numeric_limits<float>::infinity();
  EXPECT_THROW(pov_assets(scene), Error);
}

TEST(PovScene, InstancesShareTheirMesh) {
  Scene scene = golden_scene();
  scene.entities.push_back({"again", 0, glm::mat4(1)});
  EXPECT_EQ(pov_assets(scene).includes.size(), 2u);  // the mesh and what places it
}

TEST(PovScene, AttenuationByRadiusIsWarnedAbout) {
  Scene scene = golden_scene();
  scene.lights[0].kind = LightKind::point;
  EXPECT_THAT(pov_assets(scene).warnings, testing::IsEmpty());
  scene.lights[0].attenuation.kind = Attenuation::Kind::radius;
  EXPECT_THAT(pov_assets(scene).warnings, testing::ElementsAre(HasSubstr("radius")));
}

TEST(PovScene, TheErrorOfAnAttenuationByRadiusIsTold) {
  Scene scene = golden_scene();
  scene.lights[0] = Light();
  scene.lights[0].name = "torch";
  scene.lights[0].attenuation.kind = Attenuation::Kind::radius;
  EXPECT_THAT(
      pov_assets(scene).warnings,
      testing::ElementsAre(AllOf(
          HasSubstr("torch"), HasSubstr(fmt::format("up to {:.2f} %", 100 * radius_attenuation_error())))));
}

TEST(PovScene, NearAndFarAreWarnedAbout) {
  Scene scene = golden_scene();
  scene.far = 100.0f;
  EXPECT_THAT(pov_assets(scene).warnings, testing::ElementsAre(HasSubstr("near and far")));
}

TEST(PovScene, AReflectanceIsWarnedAbout) {
  Scene scene = golden_scene();
  scene.materials[0].name = "wool";
  scene.materials[0].reflectance = 0.5f;
  EXPECT_THAT(pov_assets(scene).warnings, testing::ElementsAre(HasSubstr("wool")));
}

}  // namespace
}  // namespace lightbench
