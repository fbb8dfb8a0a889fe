#include "renderer/caustics/light_traced_image.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/renderer/caustics/water_scenes.h"

namespace lightbench {
namespace {

using namespace test;

constexpr int kWidth = 64, kHeight = 48;

LightTracedOptions few_rays() {
  LightTracedOptions options;
  options.trace.rays = 2'000'000;
  options.trace.map_size = 128;
  return options;
}

TEST(LightTracedImage, ShowsTheColourTimesWhatLands) {
  Scene scene = pool_scene({3, -4, 0});
  scene.water->ambient = {0, 0, 0.1f};
  scene.background.color = {0, 0.5f, 0};
  LightTracedOptions options = few_rays();
  options.surface = false;
  const LightTracedImage made = light_traced_image(scene, top_view(6), kWidth, kHeight, 1, options);
  const auto pixel = made.image.pixel(kWidth / 2, kHeight / 2);
  // Four texels of 3000 rays each.
  EXPECT_NEAR(double(pixel[0]), 0.8 * 0.8, 0.02);
  EXPECT_NEAR(double(pixel[2]), 0.8 * (0.8 + 0.1), 0.02);
  EXPECT_LT(made.noise, 5);
  EXPECT_GT(made.noise, 0);
}

TEST(LightTracedImage, ShowsWhatTheTechniqueShows) {
  Scene scene = sphere_in_waves();
  View view = top_view(7);
  view.camera.position = {2, 7, 4};
  view.camera.look_at = {0, 1, 0};
  scene.background.color = glm::vec3(0.3f);
  LightTracedOptions options = few_rays();
  options.trace.rays = 20'000'000;
  options.trace.map_size = 512;
  const LightTracedImage made = light_traced_image(scene, view, kWidth, kHeight, 1, options);
  RenderSetup setup;
  setup.technique = "caustics";
  setup.width = kWidth;
  setup.height = kHeight;
  const Image drawn = render(scene, view, setup).image;
  double error = 0, light = 0;
  for (std::size_t i = 0; i < drawn.data.size(); i += 4) {
    error += double(std::abs(std::min(drawn.data[i], 1.0f) - std::min(made.image.data[i], 1.0f)));
    light += double(std::min(made.image.data[i], 1.0f));
  }
  // Noise, shadows' edges, and what hides behind the ball from the point that the surface is looked through
  // from.
  EXPECT_LT(error, 0.06 * light);
}

TEST(LightTracedImage, WhatIsAboveTheWaterIsLitDirectly) {
  Scene scene = pool_scene({0, -1, 0});
  add_box(scene, "quay", {{-4, 2, -4}, {-2.5f, 3, 4}});
  View view = top_view(6);
  view.camera.position.x = view.camera.look_at.x = -3;
  const LightTracedImage made = light_traced_image(scene, view, kWidth, kHeight, 1, few_rays());
  EXPECT_NEAR(double(made.image.pixel(kWidth / 2, kHeight / 2)[0]), 0.8, 1e-6);
}

TEST(LightTracedImage, NeedsWaterAndLightsThatShineThrough) {
  Scene scene = pool_scene({0, 1, 0});
  EXPECT_THROW(light_traced_image(scene, top_view(6), 4, 4, 1, few_rays()), Error);
  scene.water.reset();
  EXPECT_THROW(light_traced_image(scene, top_view(6), 4, 4, 1, few_rays()), Error);
}

}  // namespace
}  // namespace lightbench
