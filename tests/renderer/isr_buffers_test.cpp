#include <map>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/renderer/isr_scenes.h"

namespace lightbench {
namespace {

using namespace test;

std::map<std::string, Image> buffers(const Scene& scene, const View& view, const Params& params,
                                     const std::set<std::string>& names) {
  return render(scene, view,
                {.technique = "isr", .params = params, .width = 128, .height = 96, .buffers = names})
      .buffers;
}

// 0.5 %: a step across the room's edge takes it for a piece of one wall.
TEST(GlIsrBuffers, AClosedRoomIsCoveredAndKnown) {
  const auto kept = buffers(furnace(), furnace_view(), bitmask({{"steps", 96LL}}), {"coverage", "unknown"});
  EXPECT_NEAR(mean_of(kept.at("coverage")), 1, 0.005);
  EXPECT_NEAR(mean_of(kept.at("unknown")), 0, 0.005);
}

TEST(GlIsrBuffers, TheSkyIsKnownAndCoversNothing) {
  Scene scene = floor_scene();
  const View view = view_from({0, 2, 5}, {0, 0, 0}, 0.9f);
  const auto kept = buffers(scene, view, bitmask(), {"coverage", "unknown"});
  EXPECT_NEAR(kept.at("coverage").pixel(64, 48)[0], 0, 0.001);
  EXPECT_NEAR(kept.at("unknown").pixel(64, 48)[0], 0, 0.001);
}

TEST(GlIsrBuffers, WhatNoPictureShowsIsUnknown) {
  const auto unknown = [](const char* cameras) {
    const Params params = bitmask({{"cameras", cameras}});
    return mean_of(buffers(furnace(), furnace_view(), params, {"unknown"}).at("unknown"));
  };
  EXPECT_GT(unknown("none"), 0.3);
  EXPECT_LT(unknown("cube"), 0.07);
}

// Radiance 1 everywhere: 0.6 comes at once, and 0.6 of that by another bounce.
TEST(GlIsrBuffers, EachBounceIsThatMuchLess) {
  const Params params = bitmask({{"bounces", 3LL}, {"unknown", "ambient"}});
  const auto kept = buffers(furnace(), furnace_view(), params,
                            {"bounce_1", "bounce_2", "bounce_3", "bounce_4", "indirect"});
  EXPECT_NEAR(mean_of(kept.at("bounce_1")), 0.6, 0.002);
  EXPECT_NEAR(mean_of(kept.at("bounce_2")), 0.36, 0.003);
  EXPECT_NEAR(mean_of(kept.at("bounce_3")), 0.216, 0.004);
  EXPECT_EQ(range_of(kept.at("bounce_4")), std::pair(0.0f, 0.0f));
  EXPECT_NEAR(mean_of(kept.at("indirect")), 0.6 + 0.36 + 0.216, 0.005);
}

TEST(GlIsrBuffers, AskingForThemDoesNotChangeTheImage) {
  Scene scene = furnace();
  add_block(scene, 0);
  const Params params = bitmask({{"bounces", 2LL}, {"layers", 2LL}});
  const auto image = [&](const std::set<std::string>& names) {
    return render(scene, furnace_view(), {.technique = "isr", .params = params, .buffers = names}).image.data;
  };
  EXPECT_EQ(image({}), image({"bounce_1", "surround", "layer_2", "coverage", "unknown", "occlusion"}));
}

// The block hides a piece of the back wall, which is the second layer there.
TEST(GlIsrBuffers, TheSecondLayerIsBehindTheFirst) {
  Scene scene = furnace();
  scene.materials.push_back(matte(glm::vec3(0)));
  add_block(scene, 1);
  const Params params = bitmask({{"layers", 2LL}, {"guard_resolution", 1LL}});
  const auto kept = buffers(scene, furnace_view(), params, {"layer_2", "albedo"});
  const Image& layer = kept.at("layer_2");
  int behind = 0;
  for (int y = 0; y < layer.height; ++y)
    for (int x = 0; x < layer.width; ++x) {
      const bool block = kept.at("albedo").pixel(x, y)[0] == 0;
      if (block && layer.pixel(x, y)[0] > 0.9f) ++behind;
      // Nothing is behind the walls. Pixels at the block's rim may show either.
      if (!block && y < 10) {
        EXPECT_EQ(layer.pixel(x, y)[0], 0);
      }
    }
  EXPECT_GT(behind, 300);
}

TEST(GlIsrBuffers, TheSurroundingsAreAllAround) {
  const Image around = buffers(furnace(), furnace_view(), bitmask(), {"surround"}).at("surround");
  EXPECT_EQ(range_of(around), std::pair(1.0f, 1.0f));
  const Image ahead =
      buffers(furnace(), furnace_view(), bitmask({{"cameras", "none"}}), {"surround"}).at("surround");
  EXPECT_EQ(ahead.pixel(64, 48)[0], 1);
  EXPECT_EQ(ahead.pixel(2, 48)[0], 0);
}

TEST(GlIsrBuffers, AllAreBlackWhereThereIsNothingToKeep) {
  const auto kept = buffers(furnace(), furnace_view(), {}, {"surround", "layer_2", "layer_4", "bounce_2"});
  for (const auto& [name, image] : kept) EXPECT_EQ(range_of(image), std::pair(0.0f, 0.0f)) << name;
  EXPECT_EQ(kept.size(), 4u);
}

// The wall right beside a floor's point covers half of its directions; only what is near darkens it.
TEST(GlIsrBuffers, NearSurfacesOcclude) {
  Scene scene = floor_scene();
  add_quad(scene, {1, 0, -10}, {0, 0, 20}, {0, 5, 0});
  const View view = top_view(4);
  const auto openness = [&](double radius) {
    const Params params =
        bitmask({{"slices", 8LL}, {"steps", 64LL}, {"occlusion_radius", radius}, {"blur", "none"}});
    const auto kept = buffers(scene, view, params, {"occlusion"});
    return std::pair(kept.at("occlusion").pixel(84, 48)[0], kept.at("occlusion").pixel(10, 48)[0]);
  };
  const auto [beside, far_off] = openness(0.1);
  EXPECT_LT(beside, 0.75);
  EXPECT_GT(beside, 0.5);
  EXPECT_NEAR(far_off, 1, 0.001);
  EXPECT_LT(openness(4.0).second, 0.97);
}

TEST(GlIsrBuffers, TheMasksOcclusionDarkensDirectLight) {
  Scene scene = floor_scene();
  add_quad(scene, {1, 0, -10}, {0, 0, 20}, {0, 5, 0});
  scene.lights = {directional_light({0.3f, -1, 0})};
  const auto corner = [&](double k_ssao) {
    const Params params =
        bitmask({{"k_ssao", k_ssao}, {"k_isr", 0.0}, {"occlusion_radius", 0.1}, {"blur", "none"}});
    return render_isr(scene, top_view(4), params).image.pixel(84, 48)[0];
  };
  EXPECT_LT(corner(1.0), 0.9f * corner(0.0));
}

}  // namespace
}  // namespace lightbench
