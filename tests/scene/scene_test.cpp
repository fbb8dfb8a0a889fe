#include "scene/scene.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "scene/box_mesh.h"
#include "scene/nearest_surface.h"
#include "tests/radius_attenuation.h"

namespace lightbench {
namespace {

Scene scene_of_box(const glm::vec3& min, const glm::vec3& max) {
  Scene scene;
  scene.materials.emplace_back();
  Bounds box;
  box.add(min);
  box.add(max);
  scene.meshes.push_back(box_mesh("box", box, 0));
  scene.entities.push_back({"box", 0, glm::mat4(1)});
  return scene;
}

Camera camera_at(const glm::vec3& position, const glm::vec3& look_at) {
  Camera camera;
  camera.position = position;
  camera.look_at = look_at;
  return camera;
}

TEST(Attenuation, NoneIsOneAtAnyDistance) {
  EXPECT_EQ(attenuation_factor({}, 123.0f), 1.0f);
}

TEST(Attenuation, FadeIsOneAtItsDistanceAndTwoAtTheLight) {
  const Attenuation fade{Attenuation::Kind::fade, 3.0f, 2.0f, 1.0f};
  EXPECT_FLOAT_EQ(attenuation_factor(fade, 3.0f), 1.0f);
  EXPECT_FLOAT_EQ(attenuation_factor(fade, 6.0f), 0.4f);
  EXPECT_NEAR(attenuation_factor(fade, 1e-4f), 2.0f, 1e-6f);
}

TEST(Attenuation, InverseSquareQuartersWhenTheDistanceDoubles) {
  const Attenuation square{Attenuation::Kind::inverse_square, 1, 2, 1};
  EXPECT_FLOAT_EQ(attenuation_factor(square, 0.5f), 4.0f);
  EXPECT_FLOAT_EQ(attenuation_factor(square, 2.0f), 0.25f);
}

TEST(Attenuation, RadiusFallsWithTheSquareAndEndsAtTheRadius) {
  const Attenuation radius{Attenuation::Kind::radius, 1, 2, 4.0f};
  for (const auto& [part, factor] : test::kRadiusFactors)
    EXPECT_EQ(attenuation_factor(radius, part * 4.0f), factor) << part << "; exact in binary";
}

TEST(CameraFrame, LooksAlongMinusZWithXToTheRight) {
  const CameraFrame frame = camera_frame(Camera{});
  EXPECT_EQ(frame.forward, glm::vec3(0, 0, -1));
  EXPECT_EQ(frame.right, glm::vec3(1, 0, 0));
  EXPECT_EQ(frame.up, glm::vec3(0, 1, 0));
}

RC_GTEST_PROP(CameraFrame, IsOrthonormalAndRightHanded, (int x, int y, int z)) {
  Camera camera;
  camera.look_at = glm::vec3(x % 100, y % 100, z % 100);
  RC_PRE(x % 100 != 0 || z % 100 != 0);
  const CameraFrame f = camera_frame(camera);
  // Rounding of 32-bit floats.
  RC_ASSERT(glm::length(glm::cross(f.right, f.up) + f.forward) < 1e-5f);
  RC_ASSERT(std::abs(glm::length(f.up) - 1) < 1e-5f);
}

TEST(SceneBounds, CoverTransformedEntities) {
  Scene scene = scene_of_box({0, 0, 0}, {1, 2, 3});
  scene.entities.push_back({"moved", 0, glm::translate(glm::mat4(1), glm::vec3(10, 0, 0))});
  const Bounds bounds = world_bounds(scene);
  EXPECT_EQ(bounds.min, glm::vec3(0, 0, 0));
  EXPECT_EQ(bounds.max, glm::vec3(11, 2, 3));
  EXPECT_FLOAT_EQ(bounds.diagonal(), std::sqrt(121.0f + 4.0f + 9.0f));
}

TEST(SceneBounds, OfAnEmptySceneAreEmpty) {
  EXPECT_TRUE(world_bounds(Scene{}).empty());
  EXPECT_EQ(Bounds{}.diagonal(), 0.0f);
}

TEST(TriangleCount, CountsInstancesEach) {
  Scene scene = scene_of_box({0, 0, 0}, {1, 1, 1});
  scene.entities.push_back(scene.entities.front());
  EXPECT_EQ(triangle_count(scene), 24u);
}

TEST(NearestSurface, IsMeasuredToFacesEdgesAndCorners) {
  const Scene scene = scene_of_box({0, 0, 0}, {1, 1, 1});
  EXPECT_FLOAT_EQ(distance_to_nearest_surface(scene, {0.5f, 0.4f, 3.0f}), 2.0f);
  EXPECT_FLOAT_EQ(distance_to_nearest_surface(scene, {4.0f, 5.0f, 0.5f}), 5.0f);
  EXPECT_FLOAT_EQ(distance_to_nearest_surface(scene, {3.0f, 3.0f, 2.0f}), 3.0f);
  EXPECT_FLOAT_EQ(distance_to_nearest_surface(scene, {0.5f, 0.5f, 0.9f}), 0.1f);
}

TEST(NearestSurface, CountsTheTransform) {
  Scene scene = scene_of_box({0, 0, 0}, {1, 1, 1});
  scene.entities[0].transform = glm::scale(glm::mat4(1), glm::vec3(2));
  EXPECT_FLOAT_EQ(distance_to_nearest_surface(scene, {1, 1, 5}), 3.0f);
}

TEST(DepthRange, IsTheScenesOwnWhereGiven) {
  Scene scene = scene_of_box({0, 0, 0}, {1, 1, 1});
  scene.near = 0.25f;
  scene.far = 70.0f;
  const DepthRange range = depth_range(scene, camera_at({0.5f, 0.5f, 5}, {0.5f, 0.5f, 0}));
  EXPECT_EQ(range.near, 0.25f);
  EXPECT_EQ(range.far, 70.0f);
}

TEST(DepthRange, EndsWhereTheBoundsEnd) {
  const Scene scene = scene_of_box({-1, -1, -1}, {1, 1, 1});
  const DepthRange range = depth_range(scene, camera_at({0, 0, 5}, {0, 0, 0}));
  EXPECT_GE(range.far, 6.0f);
  EXPECT_LT(range.far, 6.1f);
}

TEST(DepthRange, ClipsNothingOfAWallCloseToTheCamera) {
  const Scene scene = scene_of_box({-500, -500, -500}, {500, 500, 500});
  for (const float distance : {100.0f, 1.0f, 0.01f}) {
    // Grazing along the wall x = 500: the corner of a wide picture sees it at the least depth.
    const Camera camera = camera_at({500 - distance, 0, 0}, {500 - distance, 0, -1});
    const float corner = std::tan(0.5f * camera.fov) * 2.4f;
    EXPECT_LT(depth_range(scene, camera).near, distance / corner) << distance;
  }
}

TEST(DepthRange, KeepsTheRatioThatDepthBuffersResolve) {
  const Scene scene = scene_of_box({-500, -500, -500}, {500, 500, 500});
  const DepthRange touching = depth_range(scene, camera_at({500, 0, 0}, {0, 0, 0}));
  EXPECT_FLOAT_EQ(touching.near / touching.far, 1e-6f);
  const DepthRange open = depth_range(scene, camera_at({0, 0, 100000}, {0, 0, 0}));
  EXPECT_FLOAT_EQ(open.near / open.far, 1e-2f);
}

TEST(DepthRange, IsAVolumeEvenWhenTheCameraLooksAway) {
  const Scene scene = scene_of_box({-1, -1, -1}, {1, 1, 1});
  const DepthRange range = depth_range(scene, camera_at({0, 0, 5}, {0, 0, 10}));
  EXPECT_GT(range.near, 0.0f);
  EXPECT_LT(range.near, range.far);
}

TEST(DepthRange, OfAnEmptySceneIsAVolume) {
  const DepthRange range = depth_range(Scene{}, Camera{});
  EXPECT_GT(range.near, 0.0f);
  EXPECT_LT(range.near, range.far);
}

TEST(DepthRange, AGivenNearBehindTheBoundsStillGivesAVolume) {
  Scene scene = scene_of_box({-1, -1, -1}, {1, 1, 1});
  scene.near = 1000.0f;
  const DepthRange range = depth_range(scene, camera_at({0, 0, 5}, {0, 0, 0}));
  EXPECT_EQ(range.near, 1000.0f);
  EXPECT_GT(range.far, 1000.0f);
}

TEST(BoxMesh, FacesPointOutward) {
  Bounds box;
  box.add({-1, -2, -3});
  box.add({1, 2, 3});
  const Mesh mesh = box_mesh("box", box, 0);
  ASSERT_EQ(mesh.triangles.size(), 12u);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 n =
        glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
    EXPECT_GT(glm::dot(n, mesh.positions[t.x]), 0.0f);
    EXPECT_GT(glm::dot(n, mesh.normals[t.x]), 0.0f);
  }
}

}  // namespace
}  // namespace lightbench
