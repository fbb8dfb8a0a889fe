#include "renderer/path_tracer.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "base/color.h"
#include "base/error.h"
#include "renderer/rays.h"
#include "scene/box_mesh.h"
#include "scene/motion.h"
#include "tests/renderer/render_scene.h"
#include "tests/renderer/room_scenes.h"

namespace lightbench {
namespace {

using test::add_quad;
using test::box_scene;
using test::directional_light;
using test::floor_point;
using test::floor_scene;
using test::inside_view;
using test::matte;
using test::point_light;
using test::room;
using test::top_view;

PathTracerOptions with_bounces(int bounces, int samples = 64) {
  PathTracerOptions options;
  options.bounces = bounces;
  options.samples = samples;
  return options;
}

Image traced(const Scene& scene, const View& view, const PathTracerOptions& options, int width = 16,
             int height = 12) {
  return trace_paths(scene, view, width, height, 1, options).image;
}

double mean_of(const Image& image, int channel = 0) {
  double sum = 0;
  for (std::size_t i = 0; i < image.pixel_count(); ++i)
    sum += double(image.data[4 * i + std::size_t(channel)]);
  return sum / double(image.pixel_count());
}

/// Mean absolute difference of the sRGB images, of 255.
double difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i)
    if (i % 4 != 3)
      sum += 255 * std::abs(double(srgb_encode(std::clamp(a.data[i], 0.0f, 1.0f))) -
                            double(srgb_encode(std::clamp(b.data[i], 0.0f, 1.0f))));
  return sum / double(3 * a.pixel_count());
}

Scene emitting_floor_scene(float emission) {
  Scene scene = floor_scene();
  scene.materials[0].emission = glm::vec3(emission);
  return scene;
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

TEST(PathTracer, DependsOnTheSeedAlone) {
  PathTracerOptions options = with_bounces(2, 16);
  const Image one = traced(room(), inside_view(), options, 40, 36);
  options.threads = 2;
  EXPECT_EQ(traced(room(), inside_view(), options, 40, 36), one);
  options.seed = std::uint64_t(1) << 40;
  EXPECT_NE(traced(room(), inside_view(), options, 40, 36), one);
}

TEST(PathTracer, AMovingEntityIsTracedAsIfItsTransformWereBaked) {
  Scene moving = room();
  moving.entities[0].motion.keys = {{.time = 0},
                                    {.time = 2, .translate = {0.2, 0.1, 0}, .rotate = {0, 40, 0}}};
  set_time(moving, 1);
  Scene baked = moving;
  baked.entities[0].motion = {};
  baked.time = 0;
  View later = inside_view();
  later.time = 1;
  const PathTracerOptions options = with_bounces(1, 4);
  EXPECT_EQ(traced(moving, later, options, 20, 18), traced(baked, inside_view(), options, 20, 18));
}

TEST(PathTracer, SeedsDifferByTheEstimatedNoise) {
  PathTracerOptions options = with_bounces(2, 32);
  const PathTracedImage one = trace_paths(room(), inside_view(), 40, 36, 1, options);
  options.seed = 2;
  const PathTracedImage other = trace_paths(room(), inside_view(), 40, 36, 1, options);
  EXPECT_NEAR(other.noise, one.noise, 0.1 * one.noise);
  const double expected = std::sqrt(2.0) * one.noise;  // the difference of two images with that error
  EXPECT_NEAR(difference(one.image, other.image), expected, 0.25 * expected);
}

TEST(PathTracer, TheNoiseEstimateIsHonest) {
  const Image truth = traced(room(), inside_view(), with_bounces(2, 4096), 24, 18);
  for (const int samples : {4, 16, 64}) {
    const PathTracedImage image = trace_paths(room(), inside_view(), 24, 18, 1, with_bounces(2, samples));
    const double error = difference(image.image, truth);
    EXPECT_GT(image.noise, 0.7 * error) << samples;
    EXPECT_LT(image.noise, 1.5 * error) << samples << ": halves are stratified less than the whole";
  }
}

TEST(PathTracer, StopsEarlyWhereItIsEasy) {
  Scene scene = floor_scene();
  scene.background.color = glm::vec3(0.5f);
  PathTracerOptions options = with_bounces(1, 1024);
  options.noise = 0.5;
  const PathTracedImage easy = trace_paths(scene, top_view(3), 16, 16, 1, options);
  EXPECT_EQ(easy.rays[2].rays, 16u * 16 * 16) << "sixteen paths are the least that is looked at";
  const PathTracedImage hard = trace_paths(room(), inside_view(), 16, 16, 1, options);
  EXPECT_GT(hard.rays[2].rays, 2 * easy.rays[2].rays);
  EXPECT_LT(hard.noise, options.noise);
}

TEST(PathTracer, TracesAllSamplesOtherwise) {
  Scene scene = floor_scene();
  scene.background.color = glm::vec3(0.5f);
  const PathTracedImage image = trace_paths(scene, top_view(3), 20, 7, 1, with_bounces(1, 99));
  EXPECT_EQ(image.rays[0].rays, 140u);
  EXPECT_EQ(image.rays[2].rays, 140u * 100) << "an even number";
  EXPECT_EQ(image.rays[2].name, "diffuse");
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

TEST(PathTracer, TexturesAreFilteredInLinearLight) {
  Scene scene = floor_scene();
  Texture texture;
  texture.pixels = Image8(2, 1, 4, 255);
  for (int c = 0; c < 3; ++c) texture.pixels.pixel(0, 0)[std::size_t(c)] = 100;
  scene.textures = {texture};
  scene.materials[0].diffuse_texture = 0;
  scene.lights = {directional_light({0, -1, 0})};
  const float dark = srgb_decode8(100);
  const View view = top_view(3);
  const Image image = traced(scene, view, with_bounces(0), 64, 48);
  for (const int x : {0, 20, 32, 63}) {
    const float place =
        (floor_point(view, 64, 48, x, 24).x + 10) / 20 * 2 - 0.5f;  // in texels from the first's centre
    const float share = std::clamp(place, 0.0f, 1.0f);
    EXPECT_NEAR(image.pixel(x, 24)[0], 0.5f * ((1 - share) * dark + share), 1e-5f) << x;
  }
}

TEST(PathTracer, VertexColoursMultiply) {
  Scene scene = floor_scene();
  scene.meshes[0].colors.assign(4, {0.5f, 1, 0.25f});
  scene.lights = {directional_light({0, -1, 0})};
  const Image image = traced(scene, top_view(3), with_bounces(0));
  const auto pixel = image.pixel(4, 4);
  EXPECT_FLOAT_EQ(pixel[0], 0.25f);
  EXPECT_FLOAT_EQ(pixel[1], 0.5f);
  EXPECT_FLOAT_EQ(pixel[2], 0.125f);
}

TEST(PathTracer, ReflectanceScalesIndirectLightOnly) {
  Scene scene = floor_scene();
  scene.background.color = glm::vec3(1);
  scene.lights = {directional_light({0, -1, 0})};
  scene.materials[0].reflectance = 0.25f;
  EXPECT_NEAR(mean_of(traced(scene, top_view(3), with_bounces(1))), 0.5 + 0.25 * 0.5, 1e-5);
}

TEST(PathTracer, HighlightsLightNothingElse) {
  Scene scene = floor_scene();
  scene.materials.push_back(matte(glm::vec3(0)));
  scene.materials[1].specular = 1;
  add_quad(scene, {-5, 0, -1}, {10, 0, 0}, {0, 5, 0}, 1);
  scene.lights = {point_light({0, 1, 3})};
  const View view = top_view(3);
  EXPECT_EQ(traced(scene, view, with_bounces(1)), traced(scene, view, with_bounces(0)))
      << "as in POV-Ray's radiosity (measured)";
}

TEST(PathTracer, SomeOfManyLightsStandForAll) {
  Scene scene = room();
  scene.lights.clear();
  Image sum;
  for (int i = 0; i < 6; ++i) {
    Scene single = room();
    single.lights = {point_light({-1.5f + 0.6f * float(i), 1.5f, 1 - 0.3f * float(i)})};
    single.lights[0].power = 0.05f * float(1 + i * i);
    scene.lights.push_back(single.lights[0]);
    const Image image = traced(single, inside_view(), with_bounces(2, 512), 12, 9);
    if (sum.empty()) sum = Image(12, 9, 4);
    for (std::size_t k = 0; k < sum.data.size(); ++k) sum.data[k] += image.data[k];
  }
  const Image all = traced(scene, inside_view(), with_bounces(2, 512), 12, 9);
  EXPECT_NEAR(mean_of(all), mean_of(sum), 0.003 * mean_of(sum)) << "55296 paths each";
  EXPECT_LT(difference(all, sum), 1.0) << "the noise of both";
}

TEST(PathTracer, AnAreaLightIsItsPoints) {
  Scene scene = floor_scene();
  Light light = point_light({0, 2, 0});
  light.kind = LightKind::area;
  light.edge_u = {1, 0, 0};
  light.edge_v = {0, 0, 1};
  light.points = {2, 1};
  scene.lights = {light};
  Scene points = floor_scene();
  points.lights = {point_light({-0.25f, 2, 0}), point_light({0.25f, 2, 0})};
  for (Light& point : points.lights) point.power = 0.5f;
  EXPECT_EQ(traced(scene, top_view(3), with_bounces(1)), traced(points, top_view(3), with_bounces(1)));
}

TEST(PathTracer, ManyLightsInOnePlaceAreAsBrightAsOne) {
  Scene scene = floor_scene();
  scene.lights = {point_light({0, 2, 0})};
  scene.lights[0].power = 0.9f;
  const Image one = traced(scene, top_view(4), with_bounces(0), 32, 32);
  scene.lights.assign(36, scene.lights[0]);  // more rays than are traced at a time
  for (Light& light : scene.lights) light.power /= 36;
  const Image many = traced(scene, top_view(4), with_bounces(0), 32, 32);
  for (std::size_t i = 0; i < one.data.size(); ++i)
    EXPECT_NEAR(many.data[i], one.data[i], 1e-5f);  // 36 roundings of floats below 1
}

TEST(PathTracer, SupersamplingIsTheMeanOfFinerPixels) {
  Scene scene = room();
  scene.entities.erase(scene.entities.begin());  // sky behind
  scene.background.color = {0.1f, 0.2f, 0.9f};
  const PathTracerOptions options = with_bounces(0);
  const Image fine = box_downsample(traced(scene, inside_view(), options, 60, 42), 3);
  const Image image = trace_paths(scene, inside_view(), 20, 14, 3, options).image;
  bool partly = false;
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    EXPECT_NEAR(image.data[i], fine.data[i], 1e-6f) << "order of sums";
    partly |= i % 4 == 3 && image.data[i] > 0 && image.data[i] < 1;
  }
  EXPECT_TRUE(partly) << "alpha is coverage";
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

TEST(PathTracer, WhatIsNotPossibleIsAnError) {
  const Scene scene = floor_scene();
  const View view = top_view(3);
  const auto attempt = [&](const PathTracerOptions& options, int width = 4, int supersampling = 1) {
    trace_paths(scene, view, width, 4, supersampling, options);
  };
  EXPECT_THROW(attempt(with_bounces(-1)), Error);
  EXPECT_THROW(attempt(with_bounces(17)), Error);
  EXPECT_THROW(attempt(with_bounces(2, 1)), Error);
  PathTracerOptions options;
  options.noise = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(attempt(options), Error);
  EXPECT_THROW(attempt({}, 0), Error);
  EXPECT_THROW(attempt({}, 4, 0), Error);
  View lost = view;
  lost.camera.position.x = std::numeric_limits<float>::infinity();
  EXPECT_THROW(trace_paths(scene, lost, 4, 4, 1, {}), Error);
  EXPECT_THROW(trace_paths(Scene{}, view, 4, 4, 1, {}), Error);
  Scene broken = scene;
  broken.materials[0].emission.x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(trace_paths(broken, view, 4, 4, 1, {}), Error);
}

TEST(PathTracer, ParametersGiveTheOptions) {
  const auto resolved = [](const std::string& preset) {
    return path_tracer_options(
        resolve_params(path_tracer_params(), path_tracer_presets(), preset, {{"seed", 7LL}}, "test"));
  };
  EXPECT_EQ(resolved("two_bounces").bounces, 2);
  EXPECT_EQ(resolved("converged").bounces, 16);
  EXPECT_EQ(resolved("converged").seed, 7u);
  EXPECT_EQ(resolved("").samples, PathTracerOptions{}.samples);
}

TEST(PathTracer, TheTechniqueNeedsNoOpenGl) {
  const Technique& technique = find_technique("path_tracer", "test");
  EXPECT_FALSE(technique.needs_gl);
  const FrameResult frame = test::render(
      room(), inside_view(), {.technique = "path_tracer", .params = {{"samples", 4LL}}, .samples = 2});
  EXPECT_EQ(frame.image.width, 64);
  EXPECT_EQ(
      technique_bounces(technique, resolve_params(technique.params, technique.presets, "converged", {}, "")),
      16);
}

TEST(GlPathTracer, WithoutBouncesItIsTechniqueDirect) {
  Scene scene = room();
  scene.materials[1].specular = 0.4f;
  scene.materials[1].exponent = 20;
  scene.lights.push_back(point_light({1, 1, -1}));
  scene.lights[1].kind = LightKind::spot;
  scene.lights[1].direction = glm::normalize(glm::vec3(-1, -1, 0.2f));
  scene.lights[1].inner_angle = 0.3f;
  scene.lights[1].outer_angle = 0.8f;
  scene.lights[1].attenuation.kind = Attenuation::Kind::fade;
  const Image direct =
      test::render(scene, inside_view(), {.width = 128, .height = 96, .shadow_size = 2048}).image;
  EXPECT_LT(difference(traced(scene, inside_view(), with_bounces(0), 128, 96), direct), 0.15)
      << "shadow edges by a map's texels";
}

}  // namespace
}  // namespace lightbench
