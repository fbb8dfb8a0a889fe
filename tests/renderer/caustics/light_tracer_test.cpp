#include "renderer/caustics/light_tracer.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderer/caustics/water_light.h"
#include "scene/water.h"
#include "tests/renderer/caustics/water_scenes.h"

namespace lightbench {
namespace {

using namespace test;

LightTraceOptions few_rays() {
  LightTraceOptions options;
  options.rays = 200'000;
  options.map_size = 16;
  return options;
}

/// The mean of the texels whose middles lie in a part of the map of an entity.
glm::dvec3 mean_between(const FluxMap& map, double low, double high) {
  glm::dvec3 sum(0);
  int count = 0;
  for (int y = 0; y < map.size; ++y)
    for (int x = 0; x < map.size; ++x) {
      const double u = (x + 0.5) / map.size, w = (y + 0.5) / map.size;
      if (u < low || u > high || w < low || w > high) continue;
      sum += glm::dvec3(map.texels[std::size_t(y) * std::size_t(map.size) + std::size_t(x)]);
      ++count;
    }
  return sum / double(count);
}

glm::dvec3 flux_of(const FluxMap& map) {
  return mean_between(map, 0, 1) * map.box.size.x * map.box.size.z;
}

TEST(LightTracer, FlatWaterBrightensByTheCosines) {
  Scene scene = pool_scene({3, -4, 0});
  add_box(scene, "stone", {{-0.5f, 0, -0.5f}, {0.5f, 0.01f, 0.5f}});
  scene.water->absorption = {0, 0.1f, 0.5f};
  const LightTrace trace = trace_light(scene, scene.lights[0], few_rays());
  const double sine = 0.6 / double(scene.water->ior), cosine = std::sqrt(1 - sine * sine);
  const glm::dvec3 light = mean_between(trace.maps[1], 0.1, 0.9);
  // Stratified, 169 texels of about 60 rays: the mean is good to some thousandths.
  const double way = 1.99 / cosine;
  EXPECT_NEAR(light.r, 0.8 / cosine, 0.005);
  EXPECT_NEAR(light.g, 0.8 / cosine * std::exp(-0.1 * way), 0.005);
  EXPECT_NEAR(light.b, 0.8 / cosine * std::exp(-0.5 * way), 0.005);
}

TEST(LightTracer, AllLightIsAccountedFor) {
  Scene scene = pool_scene({1, -4, 2});
  scene.water->waves = {{0.05f, 1.5f, {0.6f, 0.8f}, 0, 0}, {0.03f, 0.9f, {1, 0}, 0, 1}};
  add_box(scene, "stone", {{-0.5f, 0.5f, -0.5f}, {0.5f, 1, 0.5f}});
  const LightTrace trace = trace_light(scene, scene.lights[0], few_rays());
  double falls = 0;
  for (const glm::vec3& flux :
       water_light(*scene.water, water_mesh(*scene.water, 0), scene.lights[0], false).flux)
    falls += double(flux.r);
  EXPECT_NEAR(falls, 16 * 4 / std::sqrt(21.0), 0.05);  // the rectangle's border is not flat
  EXPECT_NEAR(trace.sent.r, falls, 1e-4);
  EXPECT_NEAR(trace.landed.r, trace.sent.r, 1e-6);
  EXPECT_NEAR(flux_of(trace.maps[0]).r + flux_of(trace.maps[1]).r + trace.hidden.r, trace.landed.r, 1e-4);
  // Waves send some below the stone's edge, where its top stands over what they reach.
  EXPECT_GT(trace.hidden.r, 0);
  EXPECT_LT(trace.hidden.r, 0.1 * trace.landed.r);
}

TEST(LightTracer, WhatStandsAboveTheWaterShadesIt) {
  Scene scene = pool_scene({0, -1, 0});
  add_box(scene, "raft", {{-2, 3, -2}, {0, 3.1f, 2}});
  const LightTrace trace = trace_light(scene, scene.lights[0], few_rays());
  EXPECT_NEAR(trace.sent.r, 8, 0.02);
}

TEST(LightTracer, APointLightThinsOut) {
  Scene scene = pool_scene({0, -1, 0});
  add_box(scene, "stone", {{-0.1f, 0, -0.1f}, {0.1f, 0.01f, 0.1f}});
  const Light lamp = point_light({0, 3, 0});
  scene.lights = {lamp};
  LightTraceOptions options = few_rays();
  options.rays = 2'000'000;
  const LightTrace trace = trace_light(scene, lamp, options);
  // Near the axis the water moves the lamp to a distance of ior times its height above the surface.
  const double n = double(scene.water->ior), above = 1, below = 1.99;
  EXPECT_NEAR(mean_between(trace.maps[1], 0.05, 0.95).r, std::pow(n * above / (n * above + below), 2), 0.005);
}

TEST(LightTracer, ThreadsDoNotChangeIt) {
  Scene scene = pool_scene({1, -4, 2});
  scene.water->waves = {{0.05f, 1.5f, {0.6f, 0.8f}, 0, 0}};
  LightTraceOptions options = few_rays();
  const LightTrace one = trace_light(scene, scene.lights[0], options);
  options.threads = 3;
  const LightTrace three = trace_light(scene, scene.lights[0], options);
  EXPECT_EQ(one.maps[0].texels, three.maps[0].texels);
  EXPECT_EQ(one.landed, three.landed);
  options.seed = 2;
  EXPECT_NE(one.maps[0].texels, trace_light(scene, scene.lights[0], options).maps[0].texels);
}

}  // namespace
}  // namespace lightbench
