#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/renderer/isr_scenes.h"

namespace lightbench {
namespace {

using namespace test;
class GlIsrFurnace : public ::testing::TestWithParam<int> {};

// In a closed room where everything looks the same each bounce adds the albedo times the last one. 0.15 % a
// bounce: it is kept in half floats three times, which lose up to 0.05 % each.
TEST_P(GlIsrFurnace, AddsUpTheSeriesOfItsBounces) {
  const int bounces = GetParam();
  double expected = 0;
  for (int i = 0; i < bounces; ++i) expected = 0.6 * (1 + expected);
  for (const bool with_block : {false, true}) {
    Scene scene = furnace();
    if (with_block) add_block(scene, 0);
    const Params params = bitmask({{"bounces", std::int64_t{bounces}}, {"unknown", "ambient"}});
    const auto [least, most] = range_of(render_isr(scene, furnace_view(), params).buffers.at("indirect"));
    EXPECT_NEAR(least, expected, 0.0015 * bounces * expected) << with_block;
    EXPECT_NEAR(most, expected, 0.0015 * bounces * expected) << with_block;
  }
}
INSTANTIATE_TEST_SUITE_P(Bounces, GlIsrFurnace, ::testing::Values(1, 2, 3, 4));

TEST(GlIsrSlices, NeverGatherMoreThanAFullHemisphere) {
  Scene scene = furnace();
  add_block(scene, 0);
  for (const char* cameras : {"none", "cube"}) {
    const auto range =
        range_of(render_isr(scene, furnace_view(), bitmask({{"cameras", cameras}, {"unknown", "black"}}))
                     .buffers.at("indirect"));
    EXPECT_LE(range.second, 0.6f * 1.001f) << cameras;
    EXPECT_GE(range.first, 0) << cameras;
  }
}

TEST(GlIsrSlices, FacingPlatesSeeEachOtherByTheirFormFactor) {
  // 2 %: pixels that the plates' rims cut, and texels of the surround that they cut.
  const auto ratio = [](long long steps) {
    return plates_ratio(bitmask({{"slices", 16LL}, {"steps", steps}, {"guard_resolution", 1LL}}), 384);
  };
  EXPECT_NEAR(ratio(192), 1, 0.02);
  // Steps that are wider than what they look for find it too seldom, as the documentation says.
  EXPECT_NEAR(ratio(48), 0.98, 0.02);
  EXPECT_NEAR(ratio(12), 0.79, 0.02);
}

/// A floor, and a lamp of 1 x 1 above it; the camera looks at the floor from between them.
Scene lamp_over_floor() {
  Scene scene;
  scene.name = "lamp over floor";
  scene.materials = {matte(glm::vec3(1)), glowing(1), matte(glm::vec3(0))};
  add_quad(scene, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0);
  add_quad(scene, {-0.5f, 2, -0.5f}, {1, 0, 0}, {0, 0, 1}, 1);
  return scene;
}

/// What the middle of the floor shows.
float light_below(const Scene& scene, const Params& params) {
  const Image indirect = render_isr(scene, top_view(1), params, 64, 64).buffers.at("indirect");
  return indirect.pixel(32, 32)[0];
}

TEST(GlIsrSlices, ACubeSeesWhatIsBehindTheCamera) {
  const double expected = 4 * corner_parallel(0.5, 0.5, 2);
  const Scene scene = lamp_over_floor();
  EXPECT_EQ(light_below(scene, bitmask({{"cameras", "none"}})), 0);
  // 3 %: 16 slices, and texels of the cube at the lamp's rim.
  EXPECT_NEAR(light_below(scene, bitmask({{"slices", 16LL}, {"steps", 48LL}})), expected, 0.03 * expected);
}

TEST(GlIsrSlices, AScreenHidesTheLamp) {
  Scene scene = lamp_over_floor();
  add_quad(scene, {-1, 1.5f, -1}, {2, 0, 0}, {0, 0, 2}, 2);
  EXPECT_LT(light_below(scene, bitmask({{"layers", 2LL}})), 0.01f);
}

// The screen hides the lamp from the camera, not from the floor.
TEST(GlIsrSlices, LayersShowWhatTheCameraDoesNotSee) {
  const Scene open = lamp_over_floor();
  Scene screened = open;
  add_quad(screened, {-0.2f, 1.1f, -0.2f}, {0.4f, 0, 0}, {0, 0, 0.4f}, 2);
  const Params one = bitmask({{"slices", 8LL}, {"steps", 32LL}});
  Params two = one;
  two["layers"] = 2LL;
  const View view = top_view(1);
  const auto mean = [&](const Scene& scene, const Params& params) {
    return mean_of(render_isr(scene, view, params, 64, 64).buffers.at("indirect"));
  };
  const double with_one = mean(screened, one), with_two = mean(screened, two);
  EXPECT_GT(with_two, 1.5 * with_one);
  EXPECT_LT(with_two, mean(open, two));
}

// A sheet is lit from above: the floor below sees its dark side, the ceiling its bright one.
TEST(GlIsrSlices, TheTwoSidesOfASheetDiffer) {
  Scene scene;
  scene.name = "sheet";
  scene.materials = {matte(glm::vec3(1))};
  add_quad(scene, {-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
  add_quad(scene, {-1, 1, 1}, {2, 0, 0}, {0, 0, -2});
  scene.lights = {directional_light({0, -1, 0})};
  const View view = view_from({0, 2, 4}, {0, 0.6f, 0}, 0.9f);
  const Image direct = render(scene, view, {.technique = "direct", .width = 128, .height = 96}).image;
  const Image indirect = render_isr(scene, view, bitmask({{"slices", 8LL}})).buffers.at("indirect");
  double in_shadow = 0;
  int count = 0;
  for (int y = 0; y < direct.height; ++y)
    for (int x = 0; x < direct.width; ++x)
      if (direct.pixel(x, y)[3] == 1 && direct.pixel(x, y)[0] == 0)
        in_shadow += indirect.pixel(x, y)[0], ++count;
  ASSERT_GT(count, 100);
  // The shadow on the floor sees the sheet from below, which is dark: were it bright, half of the light would
  // be there.
  EXPECT_LT(in_shadow / count, 0.02);
}

TEST(GlIsrSlices, UnknownDirectionsTakeTheMeanOfTheOthers) {
  Scene scene = furnace();
  const Params black = bitmask({{"cameras", "none"}, {"unknown", "black"}});
  const Params ambient = bitmask({{"cameras", "none"}, {"unknown", "ambient"}});
  EXPECT_LT(mean_of(render_isr(scene, furnace_view(), black).buffers.at("indirect")), 0.5);
  const double filled = mean_of(render_isr(scene, furnace_view(), ambient).buffers.at("indirect"));
  EXPECT_NEAR(filled, 0.6, 0.002);
}

TEST(GlIsrSlices, TheBackgroundIsKnown) {
  Scene scene = floor_scene();
  scene.background.color = glm::vec3(0.4f);
  const Params params = bitmask({{"unknown", "ambient"}});
  const View view = view_from({0, 2, 5}, {0, 0, 0}, 0.9f);
  const Image indirect = render_isr(scene, view, params).buffers.at("indirect");
  // Half a hemisphere of 0.4 and one of nothing would be more or less; albedo 0.5.
  EXPECT_NEAR(indirect.pixel(64, 48)[0], 0.2f, 0.002f);
  scene.background.lights = false;
  EXPECT_EQ(range_of(render_isr(scene, view, params).buffers.at("indirect")).second, 0);
}

// A screen beside the camera hides a quarter of the sky; the floor behind it sees all of it.
TEST(GlIsrSlices, TheBackgroundBehindTheLastSurfaceIsKnown) {
  Scene scene = floor_scene();
  scene.background.color = glm::vec3(0.4f);
  scene.materials.push_back(matte(glm::vec3(0)));
  add_quad(scene, {-3, 1.8f, 4.5f}, {6, 0, 0}, {0, 3, 0}, 1);
  const View view = view_from({0, 2, 5}, {0, 0, 0}, 0.9f);
  const auto unknown = [&](const char* faces) {
    const Params params = bitmask({{"layers", 3LL}, {"layer_faces", faces}});
    const FrameResult frame =
        render(scene, view,
               {.technique = "isr", .params = params, .width = 128, .height = 96, .buffers = {"unknown"}});
    return frame.buffers.at("unknown").pixel(64, 70)[0];
  };
  EXPECT_GT(unknown("front"), 0.05);
  EXPECT_LT(unknown("all"), 0.01);
}

TEST(GlIsrSlices, AWiderPictureSeesMore) {
  Scene scene = furnace();
  double before = 0;
  for (const double guard : {1.0, 2.0, 4.0}) {
    const Params params = bitmask({{"cameras", "none"}, {"guard", guard}});
    const double mean = mean_of(render_isr(scene, furnace_view(), params).buffers.at("indirect"));
    EXPECT_GT(mean, before * 1.05);
    before = mean;
  }
}

// The maps are fitted to more, so edges of shadows move by a texel or two; the light in them does not change.
TEST(GlIsrSlices, SharedShadowMapsShowTheSame) {
  Scene scene = furnace();
  add_block(scene, 0);
  Light lamp;
  lamp.position = {0.5f, 0.8f, 0.1f};
  scene.lights = {lamp};
  const auto mean = [&](bool shared) {
    return mean_of(render_isr(scene, furnace_view(), bitmask({{"shared_shadows", shared}})).image);
  };
  EXPECT_NEAR(mean(true), mean(false), 2e-3 * mean(false));
}

TEST(GlIsrSlices, StepsByDepthKeepTheLight) {
  const Params params = bitmask({{"samples_by_depth", 1.0}, {"unknown", "ambient"}});
  const auto [least, most] = range_of(render_isr(furnace(), furnace_view(), params).buffers.at("indirect"));
  EXPECT_NEAR(least, 0.6, 0.001) << "kept in half floats";
  EXPECT_NEAR(most, 0.6, 0.001);
}

TEST(GlIsrSlices, TheUnitOfLengthDoesNotMatter) {
  const Params params = bitmask({{"bounces", 2LL}, {"layers", 2LL}});
  Scene scene = furnace();
  add_block(scene, 0);
  View view = furnace_view();
  const double before = mean_of(render_isr(scene, view, params).image);
  for (Entity& entity : scene.entities) entity.transform = glm::mat4(glm::mat3(1000.0f));
  view.camera.position *= 1000.0f;
  view.camera.look_at *= 1000.0f;
  EXPECT_NEAR(mean_of(render_isr(scene, view, params).image), before, 1e-3 * before);
}

TEST(GlIsrSlices, AreTheSameEveryTime) {
  Scene scene = furnace();
  add_block(scene, 0);
  const Params params = bitmask({{"bounces", 2LL}, {"layers", 2LL}});
  EXPECT_EQ(render_isr(scene, furnace_view(), params).image.data,
            render_isr(scene, furnace_view(), params).image.data);
}

TEST(GlIsrSlices, WithoutVisibilityTheirParametersChangeNothing) {
  Scene scene = furnace();
  add_block(scene, 0);
  const Params others{{"slices", 9LL}, {"steps", 7LL},     {"layers", 3LL},  {"cameras", "cube"},
                      {"guard", 2.0},  {"thickness", 1.0}, {"bounces", 3LL}, {"unknown", "ambient"}};
  EXPECT_EQ(render_isr(scene, furnace_view(), {}).image.data,
            render_isr(scene, furnace_view(), others).image.data);
}

TEST(IsrSlices, CountTheirBounces) {
  const Technique& isr = find_technique("isr", "test");
  const auto bounces = [&](const Params& given) {
    return technique_bounces(isr, resolve_params(isr.params, isr.presets, "", given, "test"));
  };
  EXPECT_EQ(bounces({{"bounces", 3LL}}), 1);
  EXPECT_EQ(bounces(bitmask({{"bounces", 3LL}})), 3);
}

}  // namespace
}  // namespace lightbench
