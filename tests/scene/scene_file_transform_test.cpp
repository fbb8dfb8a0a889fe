#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/scene_file.h"
#include "scene_test_files.h"

/// Where the entities of a scene file stand.
namespace lightbench {
namespace {

// Where the square's corner (1, 0, 0), (1, 1, 0) and so on come to be.
glm::vec3 placed(const std::string& entity_keys, const glm::vec3& p) {
  const SceneTestFiles files;
  const LoadedScene loaded = load_square(files, "", entity_keys);
  EXPECT_EQ(error_count(loaded), 0u) << described(loaded, files);
  return glm::vec3(loaded.scene.entities.at(0).transform * glm::vec4(p, 1));
}

TEST(SceneFile, TurnsZUpModels) {
  EXPECT_EQ(placed(R"(, "up": "z")", {1, 2, 3}), glm::vec3(1, 3, -2));
}

TEST(SceneFile, ScalesThenRotatesAboutXYZThenTranslates) {
  EXPECT_EQ(placed(R"(, "transform": {"scale": 2})", {1, 1, 1}), glm::vec3(2, 2, 2));
  EXPECT_EQ(placed(R"(, "transform": {"rotate": [90, 0, 0]})", {0, 1, 0}), glm::vec3(0, 0, 1));
  EXPECT_EQ(placed(R"(, "transform": {"rotate": [0, 90, 0]})", {1, 0, 0}), glm::vec3(0, 0, -1));
  EXPECT_EQ(placed(R"(, "transform": {"rotate": [0, 0, 90]})", {1, 0, 0}), glm::vec3(0, 1, 0));
  EXPECT_EQ(placed(R"(, "transform": {"translate": [10, 0, 0], "rotate": [90, 90, 0], "scale": [1, 2, 1]})",
                   {0, 1, 0}),
            glm::vec3(12, 0, 0));
}

TEST(SceneFile, ReadsMatricesRowByRow) {
  EXPECT_EQ(placed(R"(, "transform": {"matrix": [0,-1,0,5, 1,0,0,6, 0,0,1,7, 0,0,0,1]})", {1, 0, 0}),
            glm::vec3(5, 7, 7));
}

TEST(SceneFile, FitsAModelIntoASizeOnItsFootprint) {
  // The unit square, z-up, lies on the ground: its extent in y is 0 and stays so.
  const std::string keys = R"(, "up": "z", "size": [4, 1, 6], "transform": {"translate": [100, 5, 0]})";
  EXPECT_EQ(placed(keys, {0, 0, 0}), glm::vec3(98, 5, 3));
  EXPECT_EQ(placed(keys, {1, 1, 0}), glm::vec3(102, 5, -3));
}

// g++ 12 rounded only the third one to a float.
TEST(SceneFile, EqualScalesAlongAllAxesAreEqual) {
  const SceneTestFiles files;
  const auto loaded =
      load_square(files, "", R"(, "transform": {"rotate": [0, 10, 0], "scale": [0.3, 0.3, 0.3]})");
  const glm::mat4& m = loaded.scene.entities.at(0).transform;
  EXPECT_EQ(m[0][0], m[2][2]);
  EXPECT_EQ(m[0][2], -m[2][0]);
}

// Three corners of map coordinates, a tenth of a unit apart.
constexpr std::string_view kFarObj =
    "v 500000.0 0 5400000.0\nv 500000.1 0 5400000.0\nv 500000.0 0 5400000.1\nf 1 2 3\n";

TEST(SceneFile, AFarModelThatIsMovedToTheOriginKeepsItsShape) {
  const SceneTestFiles files;
  files.write("far.obj", kFarObj);
  for (const char* up : {"y", "z"}) {
    const std::string move = up == std::string("y") ? "[-500000, 0, -5400000]" : "[-500000, -5400000, 0]";
    const auto loaded = load_scene_collecting(
        files.write("s.json", std::string(R"({"entities": [{"obj": "far.obj", "up": ")") + up +
                                  R"(", "transform": {"translate": )" + move + "}}]}"));
    EXPECT_THAT(described(loaded, files), ::testing::Not(::testing::HasSubstr("so far from the origin")));
    const Bounds bounds = world_bounds(loaded.scene);
    // What the corners' distance of 0.1 loses where it is added to a number below 1.
    EXPECT_NEAR(bounds.min.x, 0, 1e-6f);
    EXPECT_NEAR(bounds.diagonal(), 0.1 * std::sqrt(2.0), 1e-6);
  }
}

TEST(SceneFile, AFarModelThatStaysThereIsAWarningThatSaysWhatToDo) {
  const SceneTestFiles files;
  const auto bare = load_scene_collecting(files.write("far.obj", kFarObj));
  EXPECT_THAT(
      described(bare, files),
      ::testing::AllOf(::testing::HasSubstr("warning far.obj: the model 'far' lies so far from the origin"),
                       ::testing::HasSubstr("they are 0.5 apart. Move it by [-500000")));
  EXPECT_EQ(triangle_count(bare.scene), 1u);
  const auto placed = load_scene_collecting(files.write(
      "s.json", R"({"entities": [{"obj": "far.obj", "transform": {"translate": [-500000, 0, 0]}}]})"));
  EXPECT_THAT(described(placed, files),
              ::testing::HasSubstr("warning s.json: $.entities[0]: the model 'far'"));
}

TEST(SceneFile, AFarModelWithASizeStandsWhereItsEntitySays) {
  const SceneTestFiles files;
  files.write("far.obj", kFarObj);
  const auto loaded = load_scene_collecting(
      files.write("s.json", R"({"entities": [{"obj": "far.obj", "size": [2, 1, 2]}]})"));
  EXPECT_THAT(described(loaded, files), ::testing::Not(::testing::HasSubstr("so far from the origin")));
  const Bounds bounds = world_bounds(loaded.scene);
  // Doubles of map coordinates are 1e-9 apart, the model 0.1 wide.
  EXPECT_NEAR(bounds.min.x, -1, 1e-5f);
  EXPECT_NEAR(bounds.max.z, 1, 1e-5f);
}

TEST(SceneFile, AnEntityWithKeyframesStandsWhereItIsAtTimeZero) {
  const std::string keys = R"(, "transform": {"scale": 2}, "keyframes": [
      {"time": -1, "translate": [0, 0, 0]}, {"time": 1, "translate": [6, 0, 0]}])";
  EXPECT_EQ(placed(keys, {1, 0, 0}), glm::vec3(3 + 2, 0, 0));
}

TEST(SceneFile, ABoxMovesToo) {
  const SceneTestFiles files;
  const LoadedScene loaded = load_scene_collecting(
      files.write("s.json", R"({"entities": [{"box": {"min": [0, 0, 0], "max": [1, 1, 1]},
                                  "keyframes": [{"time": 0}, {"time": 1, "rotate": [0, 90, 0], "scale": 2}]}]})"));
  ASSERT_EQ(error_count(loaded), 0u) << described(loaded, files);
  ASSERT_EQ(loaded.scene.entities[0].motion.keys.size(), 2u);
  EXPECT_EQ(loaded.scene.entities[0].motion.keys[1].scale, glm::dvec3(2));
}

}  // namespace
}  // namespace lightbench
