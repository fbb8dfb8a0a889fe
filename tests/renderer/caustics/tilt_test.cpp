// Receivers that are tilted against the rays.
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/caustics/hit.h"
#include "renderer/caustics/level_map.h"
#include "tests/renderer/caustics/gl_frame.h"
#include "tests/renderer/caustics/tilted_water.h"

namespace lightbench {
namespace {

using namespace test;

constexpr int kSize = 64;
constexpr double kOff =
    1e-3;  // normals of the water's vertices are floats, and its rays run as long as a slice is high

/// The flux in the middle of a ramp's map, by method.
float flux_on_ramp(float rise, bool hit, Straddling straddling = Straddling::split) {
  Scene scene = tilted_water_scene();
  add_ramp(scene, rise);
  GlFrame frame(scene);
  const DrawnReceiver drawn(frame.context(), 0, {.size = kSize});
  HitOptions options;
  options.straddling = straddling;
  const GlTexture map = hit ? draw_hits(frame.context(), drawn.map, drawn.volumes, options)
                            : draw_level_map(frame.context(), drawn.map, drawn.volumes, {});
  return read_back(map, 4).pixel(kSize / 2, kSize / 2)[0];
}

TEST(GlCausticsTilt, ARampTakesLightAsItFacesTheRays) {
  const Scene scene = tilted_water_scene();
  const double step = tilted_water_step(scene);
  EXPECT_NEAR(step, 0.1221, 1e-4) << "by hand: tan(26.565 - 19.603 degrees), with an index of 1.333";
  // A ramp that rises by r for each unit along x meets, over a unit of it, the rays that pass through 1 + r
  // step units of level ground.
  const double level = tilted_water_flux(scene);
  for (const double rise : {0.0, 1.0, 2.0, -1.0, -2.0})
    for (const bool hit : {false, true})
      EXPECT_NEAR(double(flux_on_ramp(float(rise), hit)), level * (1 + rise * step), kOff)
          << rise << " " << hit;
}

TEST(GlCausticsTilt, WhatFacesAwayFromTheRaysIsDark) {
  // Seen along the axis, but steeper than the rays.
  EXPECT_EQ(flux_on_ramp(-10, false), 0);
  EXPECT_EQ(flux_on_ramp(-10, true), 0);
}

TEST(GlReceiverMap, HoldsTheSlopeOfItsTriangles) {
  Scene scene = tilted_water_scene();
  add_ramp(scene, 2);
  GlFrame frame(scene);
  const DrawnReceiver drawn(frame.context(), 0, {.size = kSize});
  const Image places = read_back(drawn.map.places, 4);
  // The box's height is that of the ramp, so that the depth goes from 1 to 0 along x, whichever side of the
  // map that is.
  for (const int at : {1, kSize / 2, kSize - 2}) {
    const auto place = places.pixel(at, at);
    EXPECT_EQ(place[1], 1) << "the receiver, from its front";
    EXPECT_NEAR(std::abs(place[2]) + std::abs(place[3]), 1, 1e-3) << at;
    EXPECT_NEAR(std::min(std::abs(place[2]), std::abs(place[3])), 0, 1e-3) << at;
  }
}

}  // namespace
}  // namespace lightbench
