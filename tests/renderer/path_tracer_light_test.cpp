#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "renderer/path_tracer.h"
#include "renderer/rays.h"
#include "tests/radius_attenuation.h"
#include "tests/renderer/path_traced.h"
#include "tests/renderer/render_scene.h"
#include "tests/renderer/room_scenes.h"

/// The light of emitters and of the background, against known answers.
namespace lightbench {
namespace {

using test::add_quad;
using test::box_scene;
using test::directional_light;
using test::floor_point;
using test::floor_scene;
using test::inside_view;
using test::matte;
using test::mean_of;
using test::point_light;
using test::room;
using test::top_view;
using test::traced;
using test::with_bounces;

TEST(PathTracer, RadiusAttenuationAtKnownDistances) {
  const View view = top_view(3);
  Scene scene = floor_scene();
  scene.lights = {point_light(floor_point(view, 16, 12, 8, 6) + glm::vec3(0, 2, 0))};
  for (const auto& [part, factor] : test::kRadiusFactors) {
    scene.lights[0].attenuation = {.kind = Attenuation::Kind::radius, .radius = test::radius_for(2, part)};
    EXPECT_NEAR(traced(scene, view, with_bounces(0, 2)).pixel(8, 6)[0], 0.5f * factor, 1e-6f)
        << part << "; floats";
  }
}

TEST(PathTracer, AnEmittingFurnaceIsAGeometricSeries) {
  Material material = matte(glm::vec3(0.5f));
  material.emission = glm::vec3(0.25f);
  const Scene scene = box_scene(material);
  double expected = 0;
  for (int bounces = 0; bounces <= 4; ++bounces) {
    expected += 0.25 * std::pow(0.5, bounces);
    const Image image = traced(scene, inside_view(), with_bounces(bounces));
    EXPECT_NEAR(mean_of(image), expected, 0.002 * expected) << "bounces " << bounces << "; 12288 paths";
  }
}

TEST(PathTracer, ABackgroundLightsAConvexBodyByItsAlbedo) {
  Scene scene = floor_scene();
  scene.background.color = {0.2f, 0.4f, 1.0f};
  for (const int bounces : {1, 5}) {
    const Image image = traced(scene, top_view(3), with_bounces(bounces, 2));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(mean_of(image, c), 0.5 * scene.background.color[c], 1e-5) << "no noise";
  }
  EXPECT_EQ(mean_of(traced(scene, top_view(3), with_bounces(0, 2))), 0);
  scene.background.lights = false;
  EXPECT_EQ(mean_of(traced(scene, top_view(3), with_bounces(5, 2))), 0);
}

TEST(PathTracer, AWallHidesHalfTheBackground) {
  Scene scene = floor_scene();
  scene.materials.push_back(matte(glm::vec3(0)));
  add_quad(scene, {0.02f, 0, 1e4f}, {0, 0, -2e4f}, {0, 1e4f, 0}, 1);
  scene.background.color = glm::vec3(1);
  View view = top_view(3);
  view.camera.position.x = view.camera.look_at.x = -0.01f;
  view.camera.fov = 0.004f;  // all pixels lie within 0.01 of the corner: the wall is seen edge-on
  EXPECT_NEAR(mean_of(traced(scene, view, with_bounces(1))), 0.25, 0.002) << "albedo / 2; 12288 paths";
}

TEST(PathTracer, ABackgroundThatDoesNotLightIsStillSeen) {
  Scene scene = floor_scene();
  scene.background = {{0.3f, 0.4f, 0.5f}, false};
  View view = top_view(3);
  view.camera.look_at = {0, 9, -1};
  const Image image = traced(scene, view, with_bounces(2));
  const auto pixel = image.pixel(3, 3);
  EXPECT_FLOAT_EQ(pixel[0], 0.3f);
  EXPECT_EQ(pixel[3], 0);
}

/// Configuration factor from a point to a parallel square of half side h, at height c above it: Howell, C-11
/// taken four times.
double square_factor(double h, double c) {
  const double x = h / c, r = std::sqrt(1 + x * x);
  return 4 / std::numbers::pi * x / r * std::atan(x / r);
}

Scene lamp_scene(float half_side, float height) {
  Scene scene = floor_scene();
  scene.materials.push_back(matte(glm::vec3(0)));
  scene.materials[1].emission = glm::vec3(2);
  add_quad(scene, {-half_side, height, -half_side}, {2 * half_side, 0, 0}, {0, 0, 2 * half_side}, 1);
  return scene;
}

/// A narrow view of the floor at the origin from beside the lamp.
View below_lamp_view() {
  View view = top_view(3);
  view.camera.position = {6, 1, 0};
  view.camera.up = {0, 1, 0};
  view.camera.fov = 5e-4f;
  return view;
}

TEST(PathTracer, ALampFollowsItsFormFactor) {
  for (const float half_side : {0.01f, 0.3f, 5.0f}) {
    const Image image = traced(lamp_scene(half_side, 2), below_lamp_view(), with_bounces(1, 256));
    const double expected = 0.5 * 2 * square_factor(double(half_side), 2);
    EXPECT_NEAR(mean_of(image), expected, 0.003 * expected) << half_side << "; 49152 paths";
  }
}

TEST(PathTracer, ASmallLampMakesNoFireflies) {
  const Image image = traced(lamp_scene(0.01f, 2), below_lamp_view(), with_bounces(1, 4));
  const double expected = 0.5 * 2 * square_factor(0.01, 2);
  double worst = 0;
  for (std::size_t i = 0; i < image.pixel_count(); ++i)
    worst = std::max(worst, std::abs(double(image.data[4 * i]) / expected - 1));
  EXPECT_LT(worst, 0.01) << "its solid angle hardly varies";
}

/// What rays alone say of the light of the lamp at a floor point, without next-event estimation.
double gathered_by_rays(const Scene& scene, const glm::vec3& point, float lamp_height, int count) {
  const SceneRays rays(scene);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(0, 1);
  int lamp = 0;
  for (int i = 0; i < count; ++i) {
    const float r = std::sqrt(uniform(random)), phi = 2 * std::numbers::pi_v<float> * uniform(random);
    const glm::vec3 direction(r * std::cos(phi), std::sqrt(1 - r * r), r * std::sin(phi));
    const auto hit = rays.closest_hit(point + glm::vec3(0, 1e-4f, 0), direction);
    lamp += hit && std::abs(hit->distance * direction.y - lamp_height) < 1e-3f;
  }
  return double(lamp) / count;
}

TEST(PathTracer, NextEventEstimationChangesNothingButNoise) {
  Scene scene = lamp_scene(1, 1.5f);
  add_quad(scene, {-4.2f, 0.7f, -3}, {4, 0, 0}, {0, 0, 6});  // hides a part of the lamp
  const double expected = 0.5 * 2 * gathered_by_rays(scene, glm::vec3(0), 1.5f, 100000);
  const Image image = traced(scene, below_lamp_view(), with_bounces(1, 256));
  EXPECT_NEAR(mean_of(image), expected, 0.01)
      << "the rays alone: 0.0015 standard error; 0.0007 that of the other";
  EXPECT_GT(expected, 0.05);
}

Scene emitting_floor_scene(float emission) {
  Scene scene = floor_scene();
  scene.materials[0].emission = glm::vec3(emission);
  return scene;
}

TEST(PathTracer, AnEmitterLightsNothingWithoutBounces) {
  const Scene scene = lamp_scene(1, 1);
  EXPECT_EQ(mean_of(traced(scene, below_lamp_view(), with_bounces(0))), 0);
  EXPECT_NEAR(mean_of(traced(emitting_floor_scene(0.7f), top_view(2), with_bounces(0))), 0.7, 1e-6);
}

TEST(PathTracer, MoreBouncesAreBrighter) {
  double before = -1, gain = 1e9;
  for (const int bounces : {0, 1, 2, 3, 4}) {
    const double mean = mean_of(traced(room(), inside_view(), with_bounces(bounces)));
    EXPECT_GT(mean, before);
    if (bounces > 0) {
      EXPECT_LT(mean - before, gain) << "each bounce adds less: albedos are below 1";
      gain = mean - before;
    }
    before = mean;
  }
}

/// An alpha-only texture of one texel.
void add_cutout(Scene& scene, int material, std::uint8_t alpha) {
  Texture texture;
  texture.pixels = Image8(1, 1, 4, alpha);
  scene.materials[std::size_t(material)].cutout_texture = int(scene.textures.size());
  scene.textures.push_back(texture);
}

TEST(PathTracer, CutOutsLetLightThrough) {
  Scene scene = floor_scene();
  scene.background.color = glm::vec3(1);
  scene.lights = {directional_light({0, -1, 0})};
  scene.materials.push_back(matte(glm::vec3(0)));
  add_quad(scene, {-10, 4, 10}, {20, 0, 0}, {0, 0, -20}, 1);
  const double covered = mean_of(traced(scene, top_view(3), with_bounces(1)));
  EXPECT_LT(covered, 0.1) << "light from the sides only";
  add_cutout(scene, 1, 127);
  EXPECT_NEAR(mean_of(traced(scene, top_view(3), with_bounces(1))), 0.5 + 0.5, 1e-5);
}

TEST(PathTracer, HolesOfEmittersAreDark) {
  Scene scene = lamp_scene(1, 1);
  add_cutout(scene, 1, 0);
  EXPECT_EQ(mean_of(traced(scene, below_lamp_view(), with_bounces(1))), 0);
}

}  // namespace
}  // namespace lightbench
