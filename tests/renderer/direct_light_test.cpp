#include "renderer/direct_light.h"

#include <gtest/gtest.h>

#include "scene/light_points.h"
#include "tests/radius_attenuation.h"
#include "tests/renderer/render_scene.h"

namespace lightbench {
namespace {

using test::add_quad;
using test::directional_light;
using test::floor_point;
using test::floor_scene;
using test::point_light;
using test::render;
using test::RenderSetup;
using test::top_view;

constexpr int kWidth = 64;
constexpr int kHeight = 48;

float red_at(const Image& image, int x, int y) {
  return image.pixel(x, y)[0];
}

// Albedo is kept in half floats (11 bits) and normals in 16 bits.
constexpr float kRelative = 1e-3f;

void expect_floor(const Scene& scene, float (*expected)(const glm::vec3& p), float tolerance = kRelative) {
  const View view = top_view(3);
  const Image image = render(scene, view).image;
  for (const auto& [x, y] : {std::pair{0, 0}, {63, 0}, {10, 40}, {32, 24}, {50, 5}}) {
    const float value = expected(floor_point(view, kWidth, kHeight, x, y));
    EXPECT_NEAR(red_at(image, x, y), value, tolerance * value + 1e-6f) << x << "," << y;
  }
}

TEST(GlDirect, APointLightFollowsTheCosine) {
  Scene scene = floor_scene();
  scene.lights = {point_light({0.5f, 2, -0.25f})};
  expect_floor(scene, [](const glm::vec3& p) {
    return 0.5f * glm::normalize(glm::vec3(0.5f, 2, -0.25f) - p).y;  // albedo * n.l, no 1/pi
  });
}

TEST(GlDirect, PowerAndColourMultiply) {
  Scene scene = floor_scene();
  scene.lights = {directional_light({0, -1, 0})};
  scene.lights[0].color = {0.5f, 1, 2};
  scene.lights[0].power = 3;
  const FrameResult frame = render(scene, top_view(3));
  const auto pixel = frame.image.pixel(20, 20);
  EXPECT_NEAR(pixel[0], 0.75f, 1e-4f);
  EXPECT_NEAR(pixel[1], 1.5f, 1e-4f);
  EXPECT_NEAR(pixel[2], 3.0f, 1e-4f);
}

TEST(GlDirect, LightsAddUp) {
  Scene scene = floor_scene();
  scene.lights = {directional_light({0, -1, 0}), directional_light({1, -1, 0}), point_light({0, 2, 0})};
  expect_floor(scene, [](const glm::vec3& p) {
    return 0.5f * (1 + std::sqrt(0.5f) + glm::normalize(glm::vec3(0, 2, 0) - p).y);
  });
}

TEST(GlDirect, ALightBelowTheSurfaceDoesNothing) {
  Scene scene = floor_scene();
  scene.lights = {point_light({0, -1, 0}), directional_light({0, 1, 0})};
  EXPECT_EQ(red_at(render(scene, top_view(3)).image, 32, 24), 0.0f);
}

Scene attenuated(const Attenuation& attenuation) {
  Scene scene = floor_scene();
  scene.lights = {point_light({0, 2, 0})};
  scene.lights[0].attenuation = attenuation;
  return scene;
}

template <typename Factor>
void expect_attenuation(const Attenuation& attenuation, Factor factor) {
  const View view = top_view(3);
  const Image image = render(attenuated(attenuation), view).image;
  for (const auto& [x, y] : {std::pair{0, 0}, {10, 40}, {32, 24}}) {
    const glm::vec3 to_light = glm::vec3(0, 2, 0) - floor_point(view, kWidth, kHeight, x, y);
    const float d = glm::length(to_light);
    const float expected = 0.5f * 2 / d * factor(d);
    EXPECT_NEAR(red_at(image, x, y), expected, kRelative * expected + 1e-6f) << x << "," << y;
  }
}

TEST(GlDirect, FadeAttenuation) {
  expect_attenuation({.kind = Attenuation::Kind::fade, .distance = 1.5f, .power = 3},
                     [](float d) { return 2 / (1 + std::pow(d / 1.5f, 3.0f)); });
}

TEST(GlDirect, InverseSquareAttenuation) {
  expect_attenuation({.kind = Attenuation::Kind::inverse_square}, [](float d) { return 1 / (d * d); });
}

TEST(GlDirect, RadiusAttenuation) {
  expect_attenuation({.kind = Attenuation::Kind::radius, .radius = 2.5f},
                     [](float d) { return std::max(0.0f, 1 - d * d / (2.5f * 2.5f)); });
}

TEST(GlDirect, RadiusAttenuationAtKnownDistances) {
  const View view = top_view(3);
  Scene scene = floor_scene();
  scene.lights = {point_light(floor_point(view, kWidth, kHeight, 32, 24) + glm::vec3(0, 2, 0))};
  for (const auto& [part, factor] : test::kRadiusFactors) {
    scene.lights[0].attenuation = {.kind = Attenuation::Kind::radius, .radius = test::radius_for(2, part)};
    EXPECT_NEAR(red_at(render(scene, view).image, 32, 24), 0.5f * factor, kRelative * 0.5f) << part;
  }
}

TEST(GlDirect, ASpotFallsOffSmoothlyInTheCosine) {
  Scene scene = floor_scene();
  Light spot = point_light({0, 2, 0});
  spot.kind = LightKind::spot;
  spot.direction = {0, -1, 0};
  spot.inner_angle = 0.2f;
  spot.outer_angle = 0.7f;
  scene.lights = {spot};
  const View view = top_view(3);
  const Image image = render(scene, view).image;
  for (int x = 0; x < kWidth; x += 3) {
    const glm::vec3 to_light = glm::normalize(glm::vec3(0, 2, 0) - floor_point(view, kWidth, kHeight, x, 24));
    const float t = glm::clamp((to_light.y - std::cos(0.7f)) / (std::cos(0.2f) - std::cos(0.7f)), 0.0f, 1.0f);
    const float expected = 0.5f * to_light.y * t * t * (3 - 2 * t);
    EXPECT_NEAR(red_at(image, x, 24), expected, 1e-3f) << x;
  }
}

TEST(GlDirect, AWideSpotIsLitToItsEdge) {
  Scene scene = floor_scene();
  Light spot = point_light({0, 0.5f, 0});
  spot.kind = LightKind::spot;
  spot.direction = {0, -1, 0};
  spot.inner_angle = 1.3f;
  spot.outer_angle = 1.4f;
  scene.lights = {spot};
  const View view = top_view(3);
  const Image image = render(scene, view).image;
  // (63, 24) lies 2.15 units aside: 1.34 rad, between the cones.
  EXPECT_GT(red_at(image, 63, 24), 0.0f);
  EXPECT_LT(red_at(image, 63, 24), 0.5f * 0.227f);
  EXPECT_NEAR(red_at(image, 40, 24),
              0.5f * 0.5f / glm::length(floor_point(view, kWidth, kHeight, 40, 24) - glm::vec3(0, 0.5f, 0)),
              1e-3f);
}

TEST(GlDirect, PhongIsUntintedAndWithoutACosine) {
  Scene scene = floor_scene();
  scene.materials[0].diffuse = glm::vec3(0);
  scene.materials[0].specular = 0.4f;
  scene.materials[0].exponent = 20;
  scene.lights = {point_light({1, 2, 0})};
  const View view = top_view(3);
  const Image image = render(scene, view).image;
  for (const auto& [x, y] : {std::pair{32, 24}, {40, 20}, {45, 24}}) {
    const glm::vec3 p = floor_point(view, kWidth, kHeight, x, y);
    const glm::vec3 l = glm::normalize(glm::vec3(1, 2, 0) - p);
    const float r_dot_v =
        glm::dot(glm::reflect(-l, glm::vec3(0, 1, 0)), glm::normalize(view.camera.position - p));
    EXPECT_NEAR(red_at(image, x, y), 0.4f * std::pow(std::max(r_dot_v, 0.0f), 20.0f), 1e-3f);
  }
}

TEST(GlDirect, EmissionShowsWithoutLights) {
  Scene scene = floor_scene();
  scene.materials[0].emission = {0.25f, 0.5f, 4};
  const FrameResult frame = render(scene, top_view(3));
  const auto pixel = frame.image.pixel(3, 3);
  EXPECT_EQ(pixel[0], 0.25f);
  EXPECT_EQ(pixel[1], 0.5f);
  EXPECT_EQ(pixel[2], 4.0f);
  EXPECT_EQ(pixel[3], 1.0f);
}

TEST(GlDirect, TheBackgroundShowsItsColourWithoutCoverage) {
  Scene scene;
  scene.materials = {test::matte(glm::vec3(0.5f))};
  add_quad(scene, {-0.2f, 0, 0.2f}, {0.4f, 0, 0}, {0, 0, -0.4f});
  scene.background.color = {0.1f, 0.2f, 3};
  scene.lights = {directional_light({0, -1, 0})};
  const Image image = render(scene, top_view(3)).image;
  EXPECT_EQ(image.pixel(0, 0)[0], 0.1f);
  EXPECT_EQ(image.pixel(0, 0)[2], 3.0f);
  EXPECT_EQ(image.pixel(0, 0)[3], 0.0f);
  EXPECT_EQ(image.pixel(32, 24)[3], 1.0f);
}

TEST(GlDirect, AnEmptySceneIsAllBackground) {
  Scene scene;
  scene.background.color = glm::vec3(0.5f);
  scene.lights = {directional_light({0, -1, 0}), point_light({0, 1, 0})};
  EXPECT_EQ(render(scene, top_view(3)).image.pixel(7, 7)[1], 0.5f);
}

Light panel(AreaShape shape) {
  Light light = point_light({-1, 2, 0.5f});
  light.kind = LightKind::area;
  light.shape = shape;
  light.edge_u = {2, 0, 0};
  light.edge_v = {0, 0.5f, -1};
  light.points = {3, 2};
  light.attenuation = {Attenuation::Kind::fade, 2, 2, 1};
  return light;
}

class GlAreaLights : public testing::TestWithParam<AreaShape> {};

TEST_P(GlAreaLights, LightAsTheirPointsDo) {
  Scene scene = floor_scene();
  scene.materials[0].specular = 0.5f;
  scene.materials[0].exponent = 10;
  add_quad(scene, {-0.5f, 1, 0.5f}, {1, 0, 0}, {0, 0, -1});  // between light and floor
  scene.lights = {panel(GetParam())};
  const Image area = render(scene, top_view(5)).image;
  scene.lights = light_points(scene);
  EXPECT_EQ(render(scene, top_view(5)).image, area);
}

INSTANTIATE_TEST_SUITE_P(GlShapes, GlAreaLights, testing::Values(AreaShape::quad, AreaShape::triangle));

TEST(GlDirect, MeanVisibilityCountsAnAreaLightOnce) {
  Scene scene = floor_scene();
  add_quad(scene, {-0.1f, 1.9f, 0.1f}, {0.2f, 0, 0}, {0, 0, -0.2f});  // hides the point light from the floor
  scene.lights = {panel(AreaShape::quad), point_light({0, 2, 0})};
  RenderSetup setup;
  setup.buffers = {"shadow"};
  View view = top_view(1.8f);
  const FrameResult result = render(scene, view, setup);
  // Off the plate's shadow in the panel's light: one light of two.
  EXPECT_NEAR(result.buffers.at("shadow").pixel(2, 24)[0], 0.5f, 0.01f);
}

}  // namespace
}  // namespace lightbench
