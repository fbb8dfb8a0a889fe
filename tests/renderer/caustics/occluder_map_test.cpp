// What stops light beside its way along a receiver's axis.
#include "renderer/caustics/occluder_map.h"

#include <functional>

#include <gtest/gtest.h>

#include "renderer/caustics/hit.h"
#include "renderer/caustics/level_map.h"
#include "tests/renderer/caustics/gl_frame.h"
#include "tests/renderer/caustics/tilted_water.h"

namespace lightbench {
namespace {

using namespace test;

constexpr int kSize = 256;
constexpr double kHalf = 0.6;  // of the floor's side

/// A floor under something, in rays that all move along x while they fall.
Scene floor_under(const std::function<void(Scene&)>& add) {
  Scene scene = tilted_water_scene();
  add_box(scene, "floor", {{-kHalf, -0.1f, -kHalf}, {kHalf, 0, kHalf}});
  add(scene);
  return scene;
}

/// The flux at points of the floor's middle line, by x.
std::vector<float> floor_flux(const Scene& scene, const std::vector<double>& xs, bool hit, bool occluders) {
  GlFrame frame(scene);
  const DrawnReceiver drawn(frame.context(), 0, {.size = kSize, .occluders = occluders});
  const GlTexture texture = hit ? draw_hits(frame.context(), drawn.map, drawn.volumes, {})
                                : draw_level_map(frame.context(), drawn.map, drawn.volumes, {});
  const Image map = read_back(texture, 4);
  std::vector<float> flux;
  for (const double x : xs) {
    const glm::dvec3 place = drawn.map.box.to_map({x, 0, 0.001});
    flux.push_back(map.pixel(int(place.x * kSize), kSize - 1 - int(place.y * kSize))[0]);
  }
  return flux;
}

/// At places of the floor by x, whether they are lit.
void expect_lit(const Scene& scene, const std::vector<std::pair<double, bool>>& expected) {
  std::vector<double> xs;
  for (const auto& [x, lit] : expected) xs.push_back(x);
  const double level = tilted_water_flux(scene);
  for (const bool hit : {false, true}) {
    const std::vector<float> flux = floor_flux(scene, xs, hit, true);
    for (std::size_t i = 0; i < xs.size(); ++i)
      EXPECT_NEAR(double(flux[i]), expected[i].second ? level : 0, 1e-3)
          << xs[i] << (hit ? " hit" : " level map");
  }
  for (const float flux : floor_flux(scene, xs, false, false))
    EXPECT_NEAR(double(flux), level, 1e-3) << "one layer does not tell";
}

TEST(GlOccluderMap, ASolidShadesAsFarAsRaysAreBentAside) {
  const Scene scene = floor_under([](Scene& s) {
    add_box(s, "post", {{-0.2f, 0, -0.2f}, {0.1f, 1.5f, 0.2f}});
  });
  // Rays move by 0.1221 for each unit: the shadow of 1.5 units ends 0.183 beside the post.
  ASSERT_NEAR(1.5 * tilted_water_step(scene), 0.183, 1e-3);
  expect_lit(
      scene,
      {{0.11, false}, {0.19, false}, {0.27, false}, {0.29, true}, {0.5, true}, {-0.21, true}, {-0.4, true}});
}

TEST(GlOccluderMap, LightPassesUnderWhatHangs) {
  const Scene scene = floor_under([](Scene& s) {
    add_box(s, "board", {{0, 1.5f, -0.4f}, {0.1f, 1.6f, 0.4f}});
  });
  // Its shadow begins 1.5 * 0.1221 beside its left side, and ends 1.6 * 0.1221 beside its right one.
  expect_lit(scene, {{0.11, true}, {0.17, true}, {0.19, false}, {0.28, false}, {0.3, true}, {-0.01, true}});
}

TEST(GlOccluderMap, ASheetStopsWhatPassesThroughIt) {
  const Scene scene = floor_under([](Scene& s) {
    Mesh sheet;
    sheet.name = "sheet";
    sheet.positions = {{-0.3f, 1.5f, -0.4f}, {-0.3f, 1.5f, 0.4f}, {0.1f, 1.5f, 0.4f}, {0.1f, 1.5f, -0.4f}};
    sheet.normals.assign(4, glm::vec3(0, 1, 0));
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    sheet.parts = {{0, 0, 2}};
    s.meshes.push_back(sheet);
    s.entities.push_back({"sheet", int(s.meshes.size()) - 1});
  });
  expect_lit(scene, {{0.11, false}, {0.27, false}, {0.29, true}, {-0.31, true}});
}

TEST(GlOccluderMap, WhatLeansOverIsNoObstacleToItself) {
  // A ramp whose lower parts are passed by rays that land on it higher up.
  for (const float rise : {-4.0f, 4.0f}) {
    Scene scene = tilted_water_scene();
    add_ramp(scene, rise);
    GlFrame frame(scene);
    const auto flux = [&](bool occluders) {
      const DrawnReceiver drawn(frame.context(), 0, {.size = kSize, .occluders = occluders});
      return read_back(draw_level_map(frame.context(), drawn.map, drawn.volumes, {}), 4);
    };
    EXPECT_EQ(flux(true), flux(false)) << rise;
  }
}

}  // namespace
}  // namespace lightbench
