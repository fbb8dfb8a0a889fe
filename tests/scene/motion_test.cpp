#include "scene/motion.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"
#include "scene/nearest_surface.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

/// A triangle at a distance of 3 from the origin that moves by these keyframes.
Scene moving_scene(std::vector<MotionKey> keys) {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{3, 0, 0}, {3, 1, 0}, {2, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  scene.meshes = {mesh};
  scene.entities = {{.name = "mover", .motion = {.keys = std::move(keys)}}};
  set_time(scene, 0);
  return scene;
}

glm::vec3 origin_at(const Motion& motion, double time) {
  return glm::vec3(transform_at(motion, time)[3]);
}

const Motion kWay = {.keys = {{.time = 1, .translate = {0, 0, 0}}, {.time = 3, .translate = {4, -2, 0}}}};

TEST(Motion, StandsStillBeforeTheFirstAndAfterTheLastKeyframe) {
  EXPECT_EQ(origin_at(kWay, 0), glm::vec3(0, 0, 0));
  EXPECT_EQ(origin_at(kWay, 1), glm::vec3(0, 0, 0));
  EXPECT_EQ(origin_at(kWay, 3), glm::vec3(4, -2, 0));
  EXPECT_EQ(origin_at(kWay, 9), glm::vec3(4, -2, 0));
}

TEST(Motion, GoesLinearlyBetweenKeyframes) {
  EXPECT_EQ(origin_at(kWay, 1.5), glm::vec3(1, -0.5f, 0));
  EXPECT_EQ(origin_at(kWay, 2), glm::vec3(2, -1, 0));
}

TEST(Motion, TurnsByTheAngleSoThatAFullTurnIsOne) {
  const Motion turn = {.keys = {{.time = 0}, {.time = 4, .rotate = {0, 360, 0}}}};
  // A quarter of the turn brings x to -z, half of it to -x: exact for right angles.
  EXPECT_EQ(glm::vec3(transform_at(turn, 1)[0]), glm::vec3(0, 0, -1));
  EXPECT_EQ(glm::vec3(transform_at(turn, 2)[0]), glm::vec3(-1, 0, 0));
}

TEST(Motion, ScalesThenTurnsThenMoves) {
  const MotionKey key{.translate = {10, 0, 0}, .rotate = {0, 0, 90}, .scale = {2, 3, 1}};
  const Motion motion = {.keys = {key, {.time = 1}}};
  EXPECT_EQ(transform_point(transform_at(motion, 0), {1, 1, 1}), glm::vec3(10 - 3, 2, 1));
}

TEST(Motion, IsAppliedAfterTheTransformAtRest) {
  Motion motion = kWay;
  motion.rest = glm::scale(glm::mat4(1), glm::vec3(2));
  EXPECT_EQ(transform_point(transform_at(motion, 2), {1, 0, 0}), glm::vec3(2 + 2, -1, 0));
}

TEST(Motion, SettingTheTimeMovesOnlyWhatMoves) {
  Scene scene = moving_scene(kWay.keys);
  scene.entities.push_back({"still", 0, glm::mat4(2)});
  set_time(scene, 2);
  EXPECT_EQ(glm::vec3(scene.entities[0].transform[3]), glm::vec3(2, -1, 0));
  EXPECT_EQ(scene.entities[1].transform, glm::mat4(2));
  EXPECT_EQ(scene.time, 2);
  set_time(scene, 0);
  EXPECT_EQ(scene.entities[0].transform, glm::mat4(1));
}

TEST(Motion, AStillSceneSweepsItsBounds) {
  Scene scene = moving_scene({});
  EXPECT_FALSE(moves(scene));
  EXPECT_EQ(swept_bounds(scene).min, world_bounds(scene).min);
  EXPECT_EQ(swept_bounds(scene).max, world_bounds(scene).max);
}

RC_GTEST_PROP(SweptBounds, HoldTheSceneAtAnyTime, (std::uint16_t part, std::int8_t angle, std::int8_t way)) {
  Scene scene = moving_scene({{.time = 0, .rotate = {double(angle), 0, 10}},
                              {.time = 1, .translate = {double(way), 0, 1}, .rotate = {20, 4.0 * angle, 0}},
                              {.time = 2, .scale = {0.5, 2, 1}}});
  RC_ASSERT(moves(scene));
  const Bounds swept = swept_bounds(scene);
  set_time(scene, part / 32768.0);
  const Bounds now = world_bounds(scene);
  const glm::vec3 slack(1e-3f);  // rounding of coordinates of a few hundred
  RC_ASSERT(glm::all(glm::lessThanEqual(swept.min, now.min + slack)));
  RC_ASSERT(glm::all(glm::lessThanEqual(now.max, swept.max + slack)));
}

CameraKey camera_key(double time, const glm::vec3& position, float fov = 1) {
  return {time, {.position = position, .look_at = {0, 0, 0}, .fov = fov}};
}

TEST(CameraMotion, GoesLinearlyBetweenKeyframes) {
  const Camera camera = camera_at({camera_key(0, {0, 0, 4}, 1), camera_key(2, {0, 2, 8}, 0.5f)}, 0.5);
  EXPECT_EQ(camera.position, glm::vec3(0, 0.5f, 5));
  EXPECT_EQ(camera.look_at, glm::vec3(0));
  EXPECT_FLOAT_EQ(camera.fov, 0.875f);
}

TEST(CameraMotion, AViewWithoutKeyframesKeepsItsCamera) {
  const View view{"v", camera_key(0, {1, 2, 3}).camera};
  EXPECT_EQ(view_at(view, 7).camera.position, glm::vec3(1, 2, 3));
  EXPECT_EQ(view_at(view, 7).time, 7);
}

TEST(CameraMotion, ACameraThatIsNotPossibleOnTheWayIsAnErrorWithItsPlace) {
  View view{"v", {}};
  view.keyframes = {camera_key(0, {0, 0, 4}), camera_key(1, {0, 0, -4})};
  view.where = "c.json: $.views[0]";
  EXPECT_NO_THROW(view_at(view, 0.25));
  try {
    view_at(view, 0.5);
    FAIL() << "the camera stands at its look_at";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "c.json: $.views[0]");
    EXPECT_THAT(error.what(), HasSubstr("at 0.5 s the camera's position is its look_at"));
  }
}

}  // namespace
}  // namespace lightbench
