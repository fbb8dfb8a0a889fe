#include "renderer/renderer.h"

#include <optional>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/motion.h"
#include "tests/renderer/render_scene.h"

namespace lightbench {
namespace {

using test::add_quad;
using test::directional_light;
using test::floor_scene;
using test::point_light;
using test::render;
using test::top_view;

// Something with edges, a shadow and shading.
Scene small_scene() {
  Scene scene = floor_scene();
  scene.materials.push_back(test::matte({0.9f, 0.2f, 0.1f}));
  add_quad(scene, {-0.7f, 0.5f, 0.4f}, {1.1f, 0.2f, 0.3f}, {0.2f, 0.3f, -1}, 1);
  scene.lights = {point_light({1, 3, 1}), directional_light({0.3f, -1, -0.2f})};
  return scene;
}

FrameResult render_direct(Renderer& renderer, const Scene& scene, const FrameRequest& request) {
  const Technique& direct = find_technique("direct", "test");
  EXPECT_EQ(&request.scene, &scene);
  return renderer.render(direct, resolve_params(direct.params, direct.presets, "", {}, "test"), request);
}

TEST(GlRenderer, EglEqualsOsmesa) {
  const Scene scene = small_scene();
  const Image osmesa = render(scene, top_view(3)).image;
  test::RenderSetup setup;
  setup.backend = GlBackend::egl;
  std::optional<Image> egl;
  try {
    egl = render(scene, top_view(3), setup).image;
  } catch (const Error& error) {
    GTEST_SKIP() << "no EGL here: " << error.what();
  }
  ASSERT_EQ(egl->data.size(), osmesa.data.size());
  // Another driver may round differently and place an edge on the other side of a pixel's centre.
  int different = 0;
  for (std::size_t i = 0; i < egl->data.size(); ++i)
    different += std::abs(egl->data[i] - osmesa.data[i]) > 0.004f;
  EXPECT_LE(different, 40);
}

TEST(GlRenderer, BothBackendsWorkInOneProcess) {
  const Scene scene = small_scene();
  const View view = top_view(3);
  Renderer osmesa(GlBackend::osmesa), egl(GlBackend::egl);
  const FrameRequest request{scene, view, 32, 24, 1, {}};
  const Image before = render_direct(osmesa, scene, request).image;
  try {
    render_direct(egl, scene, request);
  } catch (const Error& error) {
    GTEST_SKIP() << "no EGL here: " << error.what();
  }
  EXPECT_EQ(render_direct(osmesa, scene, request).image, before);
}

TEST(GlRenderer, SamplesAverageALargerPicture) {
  const Scene scene = small_scene();
  test::RenderSetup large;
  large.width = 128;
  large.height = 96;
  const Image fine = render(scene, top_view(3), large).image;
  test::RenderSetup sampled;
  sampled.samples = 2;
  sampled.buffers = {"albedo"};
  const FrameResult result = render(scene, top_view(3), sampled);
  ASSERT_EQ(result.image.width, 64);
  ASSERT_EQ(result.image.height, 48);
  EXPECT_EQ(result.buffers.at("albedo").width, 64);
  for (int c = 0; c < 4; ++c) {
    const float mean =
        (fine.pixel(40, 40)[c] + fine.pixel(41, 40)[c] + fine.pixel(40, 41)[c] + fine.pixel(41, 41)[c]) / 4;
    EXPECT_NEAR(result.image.pixel(20, 20)[c], mean, 1e-6f);
  }
}

TEST(GlRenderer, CoverageIsFractionalWithSamples) {
  Scene scene;
  scene.materials = {test::matte(glm::vec3(1))};
  add_quad(scene, {-0.4f, 0, 0.31f}, {0.77f, 0, 0.1f}, {0, 0, -0.6f});
  test::RenderSetup setup;
  setup.samples = 4;
  int fractional = 0;
  const Image image = render(scene, top_view(3), setup).image;
  for (std::size_t i = 3; i < image.data.size(); i += 4) fractional += image.data[i] > 0 && image.data[i] < 1;
  EXPECT_GT(fractional, 10);
}

TEST(GlRenderer, AChangedSceneAtTheSameAddressIsSeen) {
  Scene scene = small_scene();
  const View view = top_view(3);
  Renderer renderer(GlBackend::osmesa);
  const FrameRequest request{scene, view, 32, 24, 1, {}};
  const Image before = render_direct(renderer, scene, request).image;
  scene.materials[0].diffuse = {0.1f, 0.9f, 0.1f};
  const Image after = render_direct(renderer, scene, request).image;
  EXPECT_NE(before, after);
  Renderer fresh(GlBackend::osmesa);
  EXPECT_EQ(render_direct(fresh, scene, request).image, after);
}

// The small scene with its quad on the move, and one whose quad stands for good where that is at time 1.
struct MovingAndBaked {
  Scene moving = small_scene();
  Scene baked;

  MovingAndBaked() {
    moving.entities[1].motion.keys = {
        {.time = 0}, {.time = 2, .translate = {0.6, 0.2, 0}, .rotate = {0, 90, 20}, .scale = {1, 3, 1}}};
    set_time(moving, 1);
    baked = moving;
    baked.entities[1].motion = {};
    baked.time = 0;
    set_time(moving, 0);
  }
};

class GlMovingScene : public testing::TestWithParam<const char*> {};

TEST_P(GlMovingScene, IsDrawnAsIfItsTransformsWereBaked) {
  MovingAndBaked scenes;
  const Technique& technique = find_technique("isr", "test");
  const ParamValues params = resolve_params(technique.params, technique.presets, GetParam(), {}, "test");
  View view = top_view(3);
  const FrameRequest request{scenes.moving, view, 64, 48, 1, {}};
  Renderer renderer(GlBackend::osmesa);
  const Image before = renderer.render(technique, params, request).image;
  set_time(scenes.moving, view.time = 1);
  const Image after = renderer.render(technique, params, request).image;
  EXPECT_NE(after, before);
  const View still = top_view(3);
  Renderer fresh(GlBackend::osmesa);
  EXPECT_EQ(fresh.render(technique, params, {scenes.baked, still, 64, 48, 1, {}}).image, after);
}

INSTANTIATE_TEST_SUITE_P(Presets, GlMovingScene, testing::Values("area", "best"),
                         [](const auto& preset) { return std::string(preset.param); });

// The scene and view with all lengths multiplied and everything moved.
std::pair<Scene, View> placed(Scene scene, View view, float scale, const glm::vec3& offset) {
  const auto place = [&](glm::vec3& p) { p = p * scale + offset; };
  for (Mesh& mesh : scene.meshes)
    for (glm::vec3& p : mesh.positions) place(p);
  for (Light& light : scene.lights) place(light.position);
  place(view.camera.position);
  place(view.camera.look_at);
  return {scene, view};
}

int different_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.data.size(); i += 4) count += std::abs(a.data[i] - b.data[i]) > 0.002f;
  return count;
}

TEST(GlRenderer, TheUnitOfLengthDoesNotMatter) {
  const Image expected = render(small_scene(), top_view(3)).image;
  for (const float scale : {1e-4f, 1e-2f, 1e3f, 1e5f}) {
    const auto [scene, view] = placed(small_scene(), top_view(3), scale, {});
    // Rounding may move an edge over a pixel's or a texel's centre.
    EXPECT_LE(different_pixels(render(scene, view).image, expected), 12) << scale;
  }
}

TEST(GlRenderer, FarFromTheOriginOnlyEdgesSuffer) {
  const Image expected = render(small_scene(), top_view(3)).image;
  const auto [scene, view] = placed(small_scene(), top_view(3), 1, {3000, 500, -2000});
  // There floats are 2e-4 apart, a fiftieth of a pixel.
  EXPECT_LE(different_pixels(render(scene, view).image, expected), 40);
}

TEST(GlRenderer, PassesAreNamedAndTimed) {
  const FrameResult result = render(small_scene(), top_view(3));
  std::vector<std::string> names;
  for (const PassTime& pass : result.passes) {
    names.push_back(pass.name);
    EXPECT_GT(pass.seconds, 0);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"g-buffer", "shadow map", "direct"}));
}

TEST(GlRenderer, AnUnknownBufferIsAnsweredWithTheNearest) {
  test::RenderSetup setup;
  setup.buffers = {"albdo"};
  try {
    render(small_scene(), top_view(3), setup);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("albedo"), std::string::npos) << error.message();
  }
}

TEST(GlRenderer, ImpossibleSizesAreErrors) {
  for (const auto& [width, height, samples] :
       {std::tuple{0, 10, 1}, {100000, 100000, 1}, {32000, 16, 1}, {20000, 4, 1}, {4096, 4096, 5}}) {
    test::RenderSetup setup;
    setup.width = width;
    setup.height = height;
    setup.samples = samples;
    EXPECT_THROW(render(small_scene(), top_view(3), setup), Error) << width << " " << height;
  }
}

// The keys of pictures have the shaders of the technique's row.
TEST(GlRenderer, AShaderOutsideTheTechniquesRowIsABug) {
  Technique technique = find_technique("direct", "test");
  std::erase(technique.shaders, "shaders/fullscreen.vert.glsl");
  const Scene scene = small_scene();
  const View view = top_view(3);
  Renderer renderer(GlBackend::osmesa);
  const ParamValues params = resolve_params(technique.params, technique.presets, "", {}, "test");
  EXPECT_THROW(renderer.render(technique, params, {scene, view, 16, 12, 1, {}}), std::logic_error);
}

TEST(GlRenderer, OddSizesWork) {
  test::RenderSetup setup;
  setup.width = 33;
  setup.height = 1;
  EXPECT_EQ(render(small_scene(), top_view(3), setup).image.data.size(), 33u * 4u);
}

TEST(GlAmbient, AddsAShareOfTheMeanDirectLight) {
  Scene scene = floor_scene();
  scene.lights = {directional_light({0, -1, 0})};
  test::RenderSetup setup;
  setup.technique = "ambient";
  setup.params = {{"k", 0.4}};
  // Irradiance 1 everywhere: albedo 0.5 * (1 + 0.4).
  EXPECT_NEAR(render(scene, top_view(3), setup).image.pixel(9, 9)[0], 0.7f, 1e-4f);
}

TEST(GlAmbient, BackgroundPixelsDoNotCount) {
  Scene scene;
  scene.materials = {test::matte(glm::vec3(0.5f))};
  add_quad(scene, {-0.2f, 0, 0.2f}, {0.4f, 0, 0}, {0, 0, -0.4f});
  scene.lights = {directional_light({0, -1, 0})};
  scene.background.color = glm::vec3(0.25f);
  test::RenderSetup setup;
  setup.technique = "ambient";
  const Image image = render(scene, top_view(3), setup).image;
  EXPECT_NEAR(image.pixel(32, 24)[0], 0.75f, 1e-4f);
  EXPECT_EQ(image.pixel(0, 0)[0], 0.25f);
  EXPECT_EQ(image.pixel(0, 0)[3], 0.0f);
}

}  // namespace
}  // namespace lightbench
