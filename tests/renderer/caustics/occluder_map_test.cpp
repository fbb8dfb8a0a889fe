// What stops light beside its way along a receiver's axis.
#include "renderer/caustics/occluder_map.h"

#include <algorithm>
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

/// What is on the floor's middle line.
struct FloorOptions {
  bool hit = false;
  bool occluders = true;
  int steps = 16;
};

std::vector<float> floor_flux(const Scene& scene, const std::vector<double>& xs,
                              const FloorOptions& options) {
  GlFrame frame(scene);
  const DrawnReceiver drawn(frame.context(), 0,
                            {.size = kSize, .occluders = options.occluders, .steps = options.steps});
  const GlTexture texture = options.hit ? draw_hits(frame.context(), drawn.map, drawn.volumes, {})
                                        : draw_level_map(frame.context(), drawn.map, drawn.volumes, {});
  const Image map = read_back(texture, 4);
  std::vector<float> flux;
  for (const double x : xs) {
    const glm::dvec3 place = drawn.map.box.to_map({x, 0, 0.001});
    flux.push_back(map.pixel(int(place.x * kSize), kSize - 1 - int(place.y * kSize))[0]);
  }
  return flux;
}

/// A place of the floor, by x.
struct Place {
  double x;
  bool lit;
};

void expect_lit(const Scene& scene, const std::vector<Place>& places, int steps = 16) {
  std::vector<double> xs;
  for (const Place& place : places) xs.push_back(place.x);
  const auto level = float(tilted_water_flux(scene));
  for (const bool hit : {false, true}) {
    const std::vector<float> flux = floor_flux(scene, xs, {.hit = hit, .steps = steps});
    for (std::size_t i = 0; i < xs.size(); ++i)
      EXPECT_EQ(flux[i] > 0.5f * level, places[i].lit) << xs[i] << (hit ? " hit" : " level map");
  }
  for (const float flux : floor_flux(scene, xs, {.occluders = false}))
    EXPECT_GT(flux, 0.5f * level) << "one layer does not tell";
}

/// Places beside an edge at x whose shadow is so long: up to its end and beyond it, but for two texels of the
/// map, and within it for one step of the ray, which may leap over the edge.
std::vector<Place> shadow_behind(double x, double length, int steps = 16) {
  const double texel = 2 * kHalf / kSize;
  std::vector<Place> places{{x + length + 2 * texel, true}, {x + length + 0.1, true}};
  const double end = length - length / steps - 2 * texel;
  for (int i = 0; 2 * texel + i * 3.3 * texel < end; ++i)
    places.push_back({x + 2 * texel + i * 3.3 * texel, false});
  return places;
}

constexpr double kHeights[] = {0.2, 0.3, 0.5, 0.7, 1, 1.5, 2};

TEST(GlOccluderMap, ASolidShadesAsFarAsRaysAreBentAside) {
  ASSERT_NEAR(tilted_water_step(tilted_water_scene()), 0.1221, 1e-4) << "by which rays move for each unit";
  for (const double height : kHeights)
    for (const double foot : {0.02, 0.0, -0.05}) {  // over the floor, on it, and sunk into it
      SCOPED_TRACE(testing::Message() << height << " from " << foot);
      const Scene scene = floor_under([&](Scene& s) {
        add_box(s, "post", {{-0.2f, float(foot), -0.2f}, {0.1f, float(height), 0.2f}});
      });
      expect_lit(scene, shadow_behind(0.1, height * 0.1221));
      expect_lit(scene, {{-0.22, true}, {-0.4, true}});
    }
}

TEST(GlOccluderMap, TheSidesOfASolidStopLight) {
  // So thin that rays which cross it neither enter through its top nor leave through its bottom.
  const Scene scene = floor_under([](Scene& s) {
    add_box(s, "plate", {{0, 0, -0.4f}, {0.02f, 1.5f, 0.4f}});
  });
  expect_lit(scene, shadow_behind(0.02, 1.5 * 0.1221));
}

TEST(GlOccluderMap, LightPassesUnderWhatHangs) {
  const Scene scene = floor_under([](Scene& s) {
    add_box(s, "board", {{0, 1.2f, -0.4f}, {0.1f, 1.6f, 0.4f}});
  });
  // Its shadow begins 1.2 * 0.1221 beside its left side, and ends 1.6 * 0.1221 beside its right one.
  expect_lit(scene, {{0.11, true}, {0.135, true}, {0.16, false}, {0.28, false}, {0.31, true}, {-0.02, true}});
}

/// A rectangle between two heights, from -0.3 to 0.1 along x.
void add_sheet(Scene& scene, float left, float right, bool turned) {
  Mesh sheet;
  sheet.name = "sheet";
  sheet.positions = {{-0.3f, left, -0.4f}, {-0.3f, left, 0.4f}, {0.1f, right, 0.4f}, {0.1f, right, -0.4f}};
  sheet.normals.assign(4, glm::vec3(0, turned ? -1 : 1, 0));
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  if (turned) sheet.triangles = {{0, 2, 1}, {0, 3, 2}};
  sheet.parts = {{0, 0, 2}};
  scene.meshes.push_back(sheet);
  scene.entities.push_back({"sheet", int(scene.meshes.size()) - 1});
}

TEST(GlOccluderMap, ASheetStopsWhatPassesThroughIt) {
  for (const double height : kHeights)
    for (const bool turned : {false, true})
      for (const int steps : {7, 16, 1024}) {
        SCOPED_TRACE(testing::Message() << height << " " << turned << " " << steps);
        const Scene scene =
            floor_under([&](Scene& s) { add_sheet(s, float(height), float(height), turned); });
        expect_lit(scene, shadow_behind(0.1, height * 0.1221, steps), steps);
      }
}

TEST(GlOccluderMap, ASlopingSheetStopsAll) {
  for (const bool turned : {false, true}) {
    const Scene scene = floor_under([&](Scene& s) { add_sheet(s, 0.6f, 1.4f, turned); });
    std::vector<Place> places;
    const double end = 0.1 + 1.4 * 0.1221 * 15 / 16 - 0.01;
    for (int i = 0; 0.11 + i * 0.005 < end; ++i) places.push_back({0.11 + i * 0.005, false});
    expect_lit(scene, places);
  }
}

TEST(GlOccluderMap, WhatStandsOverTheBoxEndsWhereItDoes) {
  // A small sheet far over a stone is no column down to it.
  Scene scene = tilted_water_scene();
  add_box(scene, "stone", {{-0.4f, 0, -0.4f}, {0.4f, 0.3f, 0.4f}});
  add_sheet(scene, 2, 2, false);
  const auto level = float(tilted_water_flux(scene));
  // Its shadow, from -0.3 to 0.1, is moved by 1.7 * 0.1221 where the axis does not shade.
  for (const auto& [x, lit] : std::vector<Place>{{0.12, false}, {0.28, false}, {0.33, true}, {-0.35, true}}) {
    GlFrame frame(scene);
    const DrawnReceiver drawn(frame.context(), 0, {.size = kSize});
    const Image map = read_back(draw_level_map(frame.context(), drawn.map, drawn.volumes, {}), 4);
    const glm::dvec3 place = drawn.map.box.to_map({x, 0.3, 0.001});
    EXPECT_EQ(map.pixel(int(place.x * kSize), kSize - 1 - int(place.y * kSize))[0] > 0.5f * level, lit) << x;
  }
}

TEST(GlOccluderMap, LargeMapsAreSearchedWhole) {
  for (const float x : {-0.4f, 0.3f}) {
    const Scene scene = floor_under([&](Scene& s) {
      add_box(s, "post", {{x, 0, -0.1f}, {x + 0.1f, 1, 0.1f}});
    });
    GlFrame frame(scene);
    const DrawnReceiver drawn(frame.context(), 0, {.size = 3000});
    const Image map = read_back(draw_level_map(frame.context(), drawn.map, drawn.volumes, {}), 4);
    for (const double beside : {0.02, 0.1}) {
      const glm::dvec3 place = drawn.map.box.to_map({double(x) + 0.1 + beside, 0, 0.001});
      EXPECT_EQ(map.pixel(int(place.x * 3000), 2999 - int(place.y * 3000))[0], 0) << x << " " << beside;
    }
  }
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
