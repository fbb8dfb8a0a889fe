#include "renderer/path_tracer.h"

#include <limits>

#include <gtest/gtest.h>

#include "base/color.h"
#include "base/error.h"
#include "scene/motion.h"
#include "tests/renderer/path_traced.h"
#include "tests/renderer/render_scene.h"
#include "tests/renderer/room_scenes.h"

namespace lightbench {
namespace {

using test::add_quad;
using test::difference;
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
    return path_tracer_options(resolve_params(path_tracer_params(PathTracedUse::reference),
                                              path_tracer_presets(), preset, {{"seed", 7LL}}, "test"));
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
