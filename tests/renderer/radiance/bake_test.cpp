#include "renderer/radiance/bake.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <gmock/gmock.h>

#include "renderer/path_tracer.h"
#include "tests/renderer/room_scenes.h"

namespace lightbench {
namespace {

using namespace test;
using ::testing::ElementsAreArray;

constexpr float kHalfStep =
    1e-3f;  // half floats are rounded by half of that share, and the path tracer by less

Material glossy(float specular, float exponent) {
  Material material = matte({0.5f, 0.3f, 0.2f});
  material.specular = specular;
  material.exponent = exponent;
  return material;
}

Light lamp() {
  Light light;
  light.kind = LightKind::area;
  light.position = {0, 3, 0};
  light.edge_u = {1, 0, 0};
  light.edge_v = {0, 0, 1};
  light.points = {3, 3};
  light.attenuation.kind = Attenuation::Kind::fade;
  return light;
}

/// A floor with a board over a part of it, under a lamp.
Scene board_scene(const Material& material) {
  Scene scene = floor_scene();
  scene.materials[0] = material;
  add_quad(scene, {0.3f, 0.7f, 1}, {2, 0, 0}, {0, 0, -2});
  scene.lights = {lamp()};
  return scene;
}

/// A point of the floor of floor_scene.
MeshPoint floor_at(float x, float z) {
  const float u = (x + 10) / 20, v = (10 - z) / 20;
  return u >= v ? MeshPoint{0, u - v, v} : MeshPoint{1, u, v - u};
}
glm::vec3 colour(const HalfStack& stack, int x, int layer) {
  const auto& texel = stack.texels[stack.index(x, 0, layer)];
  return {glm::unpackHalf1x16(texel[0]), glm::unpackHalf1x16(texel[1]), glm::unpackHalf1x16(texel[2])};
}

/// A row of texels at these points.
HalfStack baked(const Scene& scene, const std::vector<MeshPoint>& points, const BakeOptions& options,
                Side side = Side::front) {
  HalfStack stack{int(points.size()), 1, options.grid, options.scale, {}};
  stack.texels.resize(points.size() * std::size_t(options.grid.layers()));
  std::vector<BakeTexel> texels;
  for (std::size_t i = 0; i < points.size(); ++i)
    texels.push_back({std::uint32_t(i), std::uint32_t(i), points[i], side});
  bake_texels(PathScene(scene), 0, texels, options, stack);
  return stack;
}

/// What the path tracer sees at a point from a direction.
glm::vec3 seen(const Scene& scene, const glm::vec3& point, const glm::vec3& direction, int bounces = 0) {
  View view;
  view.camera = {point + 0.4f * direction, point,
                 std::abs(direction.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), 0.02f};
  PathTracerOptions options;
  options.bounces = bounces;
  options.samples = 4096;
  const PathTracedImage traced = trace_paths(scene, view, 1, 1, 1, options);
  const auto pixel = traced.image.pixel(0, 0);
  return {pixel[0], pixel[1], pixel[2]};
}

void expect_near(const glm::vec3& got, const glm::vec3& expected, float share) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], expected[c], share * expected[c] + 1e-5f);
}

const std::vector<std::pair<float, float>> kPlaces{{0, 0}, {0.5f, 0.3f}, {-1.3f, 2}, {0.31f, -0.2f}, {4, 4}};

std::vector<MeshPoint> floor_points() {
  std::vector<MeshPoint> points;
  for (const auto& [x, z] : kPlaces) points.push_back(floor_at(x, z));
  return points;
}

TEST(Bake, EachDirectionShowsWhatThePathTracerSeesFromThere) {
  const Scene scene = board_scene(glossy(0.5f, 40));
  BakeOptions options;
  options.grid = {6, 7};
  const HalfStack stack = baked(scene, floor_points(), options);
  for (std::size_t i = 0; i < kPlaces.size(); ++i)
    for (int theta = 0; theta < 5; ++theta)  // the last is the horizon, from where no ray hits
      for (int phi = 0; phi < 7; ++phi) {
        const glm::vec3 direction = options.grid.direction(theta, phi);
        expect_near(colour(stack, int(i), options.grid.layer(theta, phi)),
                    seen(scene, {kPlaces[i].first, 0, kPlaces[i].second}, direction), kHalfStep);
      }
}

TEST(Bake, WhatIsMatteIsTheSameInAllDirections) {
  BakeOptions options;
  options.light_samples = 4;
  options.bounces = 1;
  options.bounce_samples = 8;
  const HalfStack stack = baked(board_scene(matte({0.5f, 0.4f, 0.3f})), floor_points(), options);
  for (int i = 0; i < stack.width; ++i)
    for (int layer = 1; layer < options.grid.layers(); ++layer)
      EXPECT_THAT(stack.texels[stack.index(i, 0, layer)],
                  ElementsAreArray(stack.texels[stack.index(i, 0, 0)]));
}

TEST(Bake, TheBackIsLitFromBehind) {
  Scene scene = floor_scene();
  scene.lights = {point_light({0, -2, 0})};
  BakeOptions options;
  options.grid = {2, 1};
  EXPECT_EQ(colour(baked(scene, {floor_at(0, 0)}, options), 0, 0), glm::vec3(0));
  expect_near(colour(baked(scene, {floor_at(0, 0)}, options, Side::back), 0, 0), glm::vec3(0.5f), kHalfStep);
}

TEST(Bake, OfAMirroredAndTurnedObjectIsInItsOwnFrame) {
  Scene scene = board_scene(glossy(0.6f, 10));
  // The floor stands upright and is turned inside out.
  scene.entities[0].transform = {{-1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, -4, 1}};
  scene.lights = {point_light({1, 1, -1})};
  BakeOptions options;
  options.grid = {6, 7};
  const MeshPoint place = floor_at(0.5f, 0.3f);
  const HalfStack stack = baked(scene, {place}, options);
  const glm::vec3 point{-0.5f, -0.3f, -4}, normal{0, 0, 1};
  const glm::mat3 frame = frame_of_normal(normal);
  ASSERT_GT(colour(stack, 0, 0).x, 0.1f) << "the modelled normals point to the light";
  for (int theta = 0; theta < 5; ++theta)
    for (int phi = 0; phi < 7; ++phi)
      expect_near(colour(stack, 0, options.grid.layer(theta, phi)),
                  seen(scene, point, frame * options.grid.direction(theta, phi)), kHalfStep);
}

TEST(Bake, GathersBouncesAsThePathTracerDoes) {
  Scene scene = room();
  BakeOptions options;
  options.grid = {2, 1};
  options.bounces = 2;
  options.bounce_samples = 4096;
  HalfStack stack{1, 1, options.grid, 1, HalfStack::Texels(2)};
  // The middle of a triangle of the wall at x = -1.99, whose normals point out of the room.
  const BakeTexel texel{0, 0, {0, 1.0f / 3, 1.0f / 3}, Side::back};
  bake_texels(PathScene(scene), 1, std::span(&texel, 1), options, stack);
  const glm::vec3 point =
      glm::vec3(-1.99f, -2, -2) + (2.0f / 3) * glm::vec3(0, 0, 4) + (1.0f / 3) * glm::vec3(0, 4, 0);
  // Both have a noise of about a percent with so many paths.
  expect_near(colour(stack, 0, 0), seen(scene, point, {1, 0, 0}, 2), 0.02f);
}

TEST(Bake, EmissionAndBouncesAddUpInAFurnace) {
  Material material = matte(glm::vec3(0.5f));
  material.emission = glm::vec3(1);
  BakeOptions options;
  options.grid = {2, 1};
  options.bounces = 3;
  options.bounce_samples = 64;
  const HalfStack stack = baked(box_scene(material), {{0, 0.3f, 0.3f}}, options, Side::back);
  // The box's normals point outwards. Emission seen from inside is the same everywhere; what noise there is
  // comes from weighting two ways to find it.
  expect_near(colour(stack, 0, 0), glm::vec3(1 + 0.5f + 0.25f + 0.125f), 0.02f);
}

TEST(Bake, DoesNotDependOnThreadsOrOnTheOtherTexels) {
  const Scene scene = board_scene(glossy(0.4f, 20));
  std::vector<MeshPoint> points;
  for (int i = 0; i < 200; ++i) points.push_back(floor_at(0.02f * float(i) - 2, 0.3f));
  BakeOptions options;
  options.grid = {4, 4};
  options.bounces = 1;
  options.bounce_samples = 4;
  options.light_samples = 3;
  const HalfStack one = baked(scene, points, options);
  options.threads = 3;
  EXPECT_EQ(baked(scene, points, options).texels, one.texels);
}

TEST(Bake, SamplesOfAnAreaLightAreRightOnAverage) {
  Scene scene = floor_scene();
  scene.lights = {lamp()};
  scene.lights[0].points = {64, 64};
  BakeOptions options;
  options.grid = {2, 1};
  for (const AreaShape shape : {AreaShape::quad, AreaShape::triangle}) {
    scene.lights[0].shape = shape;
    options.light_samples = 0;
    const glm::vec3 exact = colour(baked(scene, {floor_at(1, 1)}, options), 0, 0);
    options.light_samples = 1024;
    // Sobol points of a smooth function: far better than 1 / sqrt(1024).
    expect_near(colour(baked(scene, {floor_at(1, 1)}, options), 0, 0), exact, 2e-3f);
  }
}

TEST(Bake, KeepsSharesOfItsScale) {
  const Scene scene = board_scene(glossy(0.5f, 20));
  BakeOptions options;
  const HalfStack plain = baked(scene, floor_points(), options);
  options.scale = 4;  // which changes no digit of a half
  const HalfStack scaled = baked(scene, floor_points(), options);
  for (int layer = 0; layer < options.grid.layers(); ++layer)
    for (int x = 0; x < plain.width; ++x)
      EXPECT_EQ(4.0f * colour(scaled, x, layer), colour(plain, x, layer)) << x << " " << layer;
}

TEST(Bake, TellsOfRaysAndNoise) {
  const Scene scene = board_scene(matte(glm::vec3(0.5f)));
  BakeOptions options;
  options.grid = {2, 1};
  HalfStack stack{1, 1, options.grid, 1, HalfStack::Texels(2)};
  const BakeTexel texel{0, 0, floor_at(0, 0), Side::front};
  BakeNews news = bake_texels(PathScene(scene), 0, std::span(&texel, 1), options, stack);
  EXPECT_EQ(news.noise, 0) << "fixed light points have none";
  EXPECT_EQ(news.rays[0].rays, 9u);
  options.bounces = 1;
  options.bounce_samples = 4;
  news = bake_texels(PathScene(scene), 0, std::span(&texel, 1), options, stack);
  EXPECT_GT(news.rays[1].rays, 0u);
}

}  // namespace
}  // namespace lightbench
