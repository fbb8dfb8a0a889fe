#include "renderer/rays.h"

#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A unit square in the xy plane around the origin, facing +z, uv 0..1 with v up.
Mesh square() {
  Mesh mesh;
  mesh.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.parts = {{0, 0, 2}};
  return mesh;
}

Scene scene_of(const std::vector<glm::mat4>& transforms, Mesh mesh = square()) {
  Scene scene;
  scene.name = "test";
  scene.materials.emplace_back();
  scene.meshes.push_back(std::move(mesh));
  for (const glm::mat4& transform : transforms) scene.entities.push_back({"square", 0, transform});
  return scene;
}

/// Gives the first material a cut-out of 2x2 texels that leaves a hole in the top left quarter.
void cut_top_left(Scene& scene) {
  Texture texture;
  texture.pixels = Image8(2, 2, 4, 255);
  texture.pixels.pixel(0, 0)[3] = 127;
  texture.pixels.pixel(1, 0)[3] = 128;
  scene.textures.push_back(texture);
  scene.materials[0].cutout_texture = 0;
}

const glm::mat4 kIdentity(1);
const glm::vec3 kForward(0, 0, -1);

TEST(Rays, HitsASquareAtItsDistance) {
  const Scene scene = scene_of({kIdentity});
  const SceneRays rays(scene);
  const auto hit = rays.closest_hit({0.2f, 0.1f, 3}, kForward);
  ASSERT_TRUE(hit);
  EXPECT_FLOAT_EQ(hit->distance, 3);
  EXPECT_EQ(hit->normal, glm::vec3(0, 0, 1));
}

TEST(Rays, CountsDistanceInLengthsOfTheDirection) {
  const Scene scene = scene_of({kIdentity});
  const SceneRays rays(scene);
  EXPECT_FLOAT_EQ(rays.closest_hit({0, 0.1f, 3}, {0, 0, -2})->distance, 1.5f);
}

TEST(Rays, MissesBesideTheSquare) {
  const Scene scene = scene_of({kIdentity});
  const SceneRays rays(scene);
  EXPECT_FALSE(rays.closest_hit({0.51f, 0, 3}, kForward));
  EXPECT_FALSE(rays.closest_hit({0, 0, 3}, -kForward));
}

TEST(Rays, DoesNotTurnTheNormalTowardsTheRay) {
  const Scene scene = scene_of({kIdentity});
  const SceneRays rays(scene);
  EXPECT_EQ(rays.closest_hit({0, 0.1f, -3}, {0, 0, 1})->normal, glm::vec3(0, 0, 1));
}

TEST(Rays, TakesTheNearerOfTwoInstances) {
  const Scene scene = scene_of({glm::translate(kIdentity, {0, 0, -1}), glm::translate(kIdentity, {0, 0, 1})});
  const SceneRays rays(scene);
  EXPECT_FLOAT_EQ(rays.closest_hit({0, 0.1f, 3}, kForward)->distance, 2);
  EXPECT_FLOAT_EQ(rays.closest_hit({0, 0.1f, -3}, {0, 0, 1})->distance, 2);
}

/// Turns by 45 degrees about x, then squeezes z to a quarter.
glm::mat4 skewed() {
  return glm::scale(kIdentity, {1, 1, 0.25f}) * glm::rotate(kIdentity, glm::radians(-45.0f), {1, 0, 0});
}

TEST(Rays, NormalIsExactUnderNonUniformScale) {
  const glm::vec3 expected = glm::normalize(glm::vec3(0, 1, 4));  // across (0, 1, -1/4), pointing to +z
  const Scene single = scene_of({skewed()});
  const Scene instances = scene_of({skewed(), glm::translate(kIdentity, {9, 0, 0})});
  for (const Scene* scene : {&single, &instances}) {
    const SceneRays rays(*scene);
    const auto hit = rays.closest_hit({0.1f, 0, 3}, kForward);
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::length(hit->normal - expected), 1e-6f) << "float rounding";
    EXPECT_NEAR(glm::length(hit->normal), 1, 1e-6);
  }
}

TEST(Rays, MirroringKeepsTheOutside) {
  const Scene scene = scene_of({glm::scale(kIdentity, {-1, 1, 1})});
  const SceneRays rays(scene);
  EXPECT_EQ(rays.closest_hit({0.1f, 0, 3}, kForward)->normal, glm::vec3(0, 0, 1));
}

TEST(Rays, GoThroughCutOuts) {
  Scene single = scene_of({kIdentity});
  Scene instances = scene_of({kIdentity, glm::translate(kIdentity, {9, 0, 0})});
  for (Scene* scene : {&single, &instances}) {
    cut_top_left(*scene);
    const SceneRays rays(*scene);
    EXPECT_FALSE(rays.closest_hit({-0.25f, 0.25f, 3}, kForward)) << "alpha 127 is a hole";
    EXPECT_TRUE(rays.closest_hit({0.25f, 0.25f, 3}, kForward)) << "alpha 128 is not";
    EXPECT_TRUE(rays.closest_hit({-0.25f, -0.25f, 3}, kForward)) << "row 0 is on top";
    EXPECT_FALSE(rays.occluded({-0.25f, 0.25f, 3}, {-0.25f, 0.25f, -3}));
    EXPECT_TRUE(rays.occluded({0.25f, 0.25f, 3}, {0.25f, 0.25f, -3}));
  }
}

TEST(Rays, RepeatCutOuts) {
  Mesh mesh = square();
  for (glm::vec2& uv : mesh.uvs) uv = uv * 2.0f - glm::vec2(3, 5);
  Scene scene = scene_of({kIdentity}, mesh);
  cut_top_left(scene);
  const SceneRays rays(scene);
  EXPECT_FALSE(rays.closest_hit({-0.375f, 0.375f, 3}, kForward));
  EXPECT_FALSE(rays.closest_hit({0.125f, -0.125f, 3}, kForward));
  EXPECT_TRUE(rays.closest_hit({0.375f, -0.375f, 3}, kForward));
}

TEST(Rays, SeeWhatIsBehindACutOut) {
  Mesh mesh = square();
  mesh.parts = {{0, 0, 1}, {1, 1, 1}};
  Scene scene = scene_of({kIdentity, glm::translate(kIdentity, {0, 0, -1})}, mesh);
  scene.materials.emplace_back();
  cut_top_left(scene);
  scene.materials[1] = scene.materials[0];  // both triangles cut, in two parts
  scene.materials[0].cutout_texture = kNoTexture;
  const SceneRays rays(scene);
  EXPECT_FALSE(rays.closest_hit({-0.3f, 0.2f, 3}, kForward)) << "in the second triangle's hole";
  EXPECT_FLOAT_EQ(rays.closest_hit({0.3f, -0.2f, 3}, kForward)->distance, 3) << "the first triangle is whole";
}

TEST(Rays, OccludedBetweenTheTwoPointsOnly) {
  const Scene scene = scene_of({kIdentity});
  const SceneRays rays(scene);
  EXPECT_TRUE(rays.occluded({0.1f, 0, 1}, {0.1f, 0, -1}));
  EXPECT_FALSE(rays.occluded({0.1f, 0, 2}, {0.1f, 0, 1}));
  EXPECT_FALSE(rays.occluded({0.1f, 0, -1}, {0.1f, 0, -2}));
}

TEST(Rays, EndPointsOnASurfaceAreNotOccludedByIt) {
  const glm::mat4 far_away = glm::translate(kIdentity, {3000, 20, -7000});
  const Scene scene = scene_of({glm::rotate(far_away, 0.7f, {1, 1, 0})});
  const SceneRays rays(scene);
  const glm::vec3 on(scene.entities[0].transform * glm::vec4(0.1f, 0.2f, 0, 1));
  const glm::vec3 off(scene.entities[0].transform * glm::vec4(0.1f, 0.2f, 5, 1));
  EXPECT_FALSE(rays.occluded(on, off));
  EXPECT_FALSE(rays.occluded(off, on));
}

TEST(Rays, DegenerateQueriesHitNothing) {
  const Scene scene = scene_of({kIdentity});
  const SceneRays rays(scene);
  EXPECT_FALSE(rays.closest_hit({0, 0, 1}, {0, 0, 0}));
  EXPECT_FALSE(rays.closest_hit({kNan, 0, 1}, kForward));
  EXPECT_FALSE(rays.closest_hit({0, 0, 1}, {0, kNan, -1}));
  EXPECT_FALSE(rays.occluded({0, 0, 1}, {0, 0, 1}));
  EXPECT_FALSE(rays.occluded({0, 0, 1}, {0, 0, -std::numeric_limits<float>::infinity()}));
}

TEST(Rays, DegenerateTrianglesGiveNoNan) {
  Mesh mesh = square();
  mesh.positions.insert(mesh.positions.end(), {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {kNan, 0, 2}});
  mesh.triangles.insert(mesh.triangles.end(), {{4, 5, 6}, {0, 2, 7}});
  mesh.parts = {{0, 0, 4}};
  const Scene scene = scene_of({kIdentity}, mesh);
  const SceneRays rays(scene);
  const auto hit = rays.closest_hit({0, 0, 3}, kForward);
  ASSERT_TRUE(hit);
  EXPECT_FLOAT_EQ(hit->distance, 3);
  EXPECT_NEAR(glm::length(hit->normal), 1, 1e-6);
}

TEST(Rays, EmptySceneHasNoHits) {
  const Scene empty;
  const SceneRays rays(empty);
  EXPECT_FALSE(rays.closest_hit({0, 0, 0}, kForward));
  EXPECT_FALSE(rays.occluded({0, 0, 0}, {0, 0, 1}));
}

TEST(Rays, NoLeaksAlongSharedEdges) {
  const Scene scene = scene_of({glm::rotate(kIdentity, 0.3f, {0.3f, 1, 0.2f})});
  const SceneRays rays(scene);
  for (int i = 1; i < 1000; ++i) {  // points of the diagonal both triangles share
    const float s = static_cast<float>(i) / 1000 - 0.5f;
    const glm::vec3 target(scene.entities[0].transform * glm::vec4(s, s, 0, 1));
    EXPECT_TRUE(rays.closest_hit({0.1f, 0.3f, 2}, glm::normalize(target - glm::vec3(0.1f, 0.3f, 2)))) << i;
  }
}

TEST(Rays, SeveralThreadsAgree) {
  Scene scene = scene_of({kIdentity, skewed()});
  cut_top_left(scene);
  const SceneRays rays(scene);
  const auto trace = [&rays] {
    std::vector<float> distances;
    for (int i = 0; i < 2000; ++i) {
      const float t = static_cast<float>(i) * 0.01f;
      const auto hit = rays.closest_hit({0.6f * std::sin(t), 0.6f * std::cos(3 * t), 3}, kForward);
      distances.push_back(hit ? hit->distance : -1);
    }
    return distances;
  };
  const std::vector<float> alone = trace();
  std::vector<std::vector<float>> together(4);
  {
    std::vector<std::jthread> threads;
    for (auto& result : together) threads.emplace_back([&result, &trace] { result = trace(); });
  }
  for (const auto& result : together) EXPECT_EQ(result, alone);
}

}  // namespace
}  // namespace lightbench
