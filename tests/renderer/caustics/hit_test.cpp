#include "renderer/caustics/hit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "renderer/caustics/flux_compare.h"
#include "renderer/caustics/level_map.h"
#include "renderer/caustics/light_tracer.h"
#include "scene/water.h"
#include "tests/renderer/caustics/gl_frame.h"
#include "tests/renderer/caustics/water_scenes.h"

namespace lightbench {
namespace {

using namespace test;

Image hit_map(const Scene& scene, std::size_t entity, Straddling straddling = Straddling::split,
              int size = 128) {
  GlFrame frame(scene);
  const DrawnReceiver drawn(frame.context(), entity, {.size = size});
  HitOptions options;
  options.straddling = straddling;
  return read_back(draw_hits(frame.context(), drawn.map, drawn.volumes, options), 4);
}

FluxField traced(const Scene& scene, std::size_t entity) {
  LightTraceOptions options;
  options.rays = 4'000'000;
  options.map_size = 512;
  return flux_field(trace_light(scene, scene.lights[0], options).maps[entity]);
}

TEST(GlHit, ShowsWhatTheLightTracerShows) {
  const Scene scene = sphere_in_waves();
  for (const std::size_t entity : {0U, 1U}) {
    const FluxField expected = traced(scene, entity),
                    drawn = flux_field(hit_map(scene, entity, Straddling::split, 512));
    const FluxLikeness likeness = compare_flux(drawn, expected, 8);
    // On the ball, 4 million rays are 15 to a texel: a quarter of noise before the mean over 3 x 3. On the
    // floor light folds: where a triangle's image has next to no area, single texels take much of its light.
    EXPECT_GT(likeness.correlation, entity == 0 ? 0.97 : 0.99) << entity;
    EXPECT_NEAR(likeness.energy.value(), 1, entity == 0 ? 0.01 : 0.002) << entity;
  }
}

TEST(GlHit, TrianglesThatStraddleLightAsTheLevelMapDoesWithManyPlanes) {
  const Scene scene = sphere_in_waves();
  GlFrame frame(scene);
  const DrawnReceiver drawn(frame.context(), 1);
  HitOptions options;
  options.slices = 8000;  // on a curved surface nothing lands as exactly as one of them
  const Image swept = read_back(draw_hits(frame.context(), drawn.map, drawn.volumes, options), 4);
  LevelMapOptions planes;
  planes.slices = 8000;
  const Image cut = read_back(draw_level_map(frame.context(), drawn.map, drawn.volumes, planes), 4);
  int lit = 0, differing = 0;
  for (std::size_t i = 0; i < cut.data.size(); i += 4) {
    lit += cut.data[i] > 0;
    differing += std::abs(swept.data[i] - cut.data[i]) > 0.02f * cut.data[i];
  }
  EXPECT_GT(lit, 5000);
  // Where a texel's middle is on an edge but for a plane's distance; a gap or what counts twice would show
  // along all edges.
  EXPECT_LT(differing, lit / 100);
}

TEST(GlHit, WithoutThoseThatStraddleLightIsMissing) {
  const Scene scene = sphere_in_waves();
  const FluxField all = flux_field(hit_map(scene, 1)),
                  dropped = flux_field(hit_map(scene, 1, Straddling::drop));
  const double kept = compare_flux(dropped, all, 8).energy.value();
  EXPECT_LT(kept, 0.98);
  EXPECT_GT(kept, 0.5);
}

TEST(GlHit, ReceiversSmallerThanAnImageOfATriangleAreLit) {
  Scene scene = pool_scene({0, -1, 0});
  // In the middle of one of the triangles of half a unit.
  add_box(scene, "pebble", {{0.1f, 0, 0.3f}, {0.2f, 0.1f, 0.4f}});
  EXPECT_NEAR(double(hit_map(scene, 1).pixel(64, 64)[0]), 1, 1e-3);
}

TEST(GlHit, TexelsOnEdgesOfTheWatersTrianglesAreLitOnce) {
  Scene scene = pool_scene({0, -1, 0});
  // Smaller than the triangles at its middle, so that all straddle it; edges, and diagonals, run through the
  // middles of texels of a map with one in its middle.
  add_box(scene, "stone", {{-0.4f, 0, -0.4f}, {0.4f, 0.1f, 0.4f}});
  const Image map = hit_map(scene, 1, Straddling::split, 127);
  for (int y = 0; y < 127; ++y)
    for (int x = 0; x < 127; ++x) ASSERT_NEAR(map.pixel(x, y)[0], 1, 1e-3) << x << " " << y;
}

TEST(GlHit, NothingLandsWhereAllLightPassesBy) {
  Scene scene = pool_scene({0, -1, 0});
  add_box(scene, "stone", {{3, 0, 3}, {3.5f, 0.5f, 3.5f}});
  const Image map = hit_map(scene, 1);
  for (const float value : map.data) ASSERT_EQ(value, 0);
}

}  // namespace
}  // namespace lightbench
