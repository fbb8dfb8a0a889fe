#include <cmath>

#include <gtest/gtest.h>

#include "renderer/path_tracer.h"
#include "tests/renderer/path_traced.h"
#include "tests/renderer/render_scene.h"
#include "tests/renderer/room_scenes.h"

/// Random choices, the estimate of their noise, and when enough were made.
namespace lightbench {
namespace {

using test::difference;
using test::floor_scene;
using test::inside_view;
using test::room;
using test::top_view;
using test::traced;
using test::with_bounces;

TEST(PathTracer, DependsOnTheSeedAlone) {
  PathTracerOptions options = with_bounces(2, 16);
  const Image one = traced(room(), inside_view(), options, 40, 36);
  options.threads = 2;
  EXPECT_EQ(traced(room(), inside_view(), options, 40, 36), one);
  options.seed = std::uint64_t(1) << 40;
  EXPECT_NE(traced(room(), inside_view(), options, 40, 36), one);
}

TEST(PathTracer, SeedsDifferByTheEstimatedNoise) {
  PathTracerOptions options = with_bounces(2, 32);
  const PathTracedImage one = trace_paths(room(), inside_view(), 40, 36, 1, options);
  options.seed = 2;
  const PathTracedImage other = trace_paths(room(), inside_view(), 40, 36, 1, options);
  EXPECT_NEAR(other.noise, one.noise, 0.1 * one.noise);
  const double expected = std::sqrt(2.0) * one.noise;  // the difference of two images with that error
  EXPECT_NEAR(difference(one.image, other.image), expected, 0.25 * expected);
}

TEST(PathTracer, TheNoiseEstimateIsHonest) {
  const Image truth = traced(room(), inside_view(), with_bounces(2, 4096), 24, 18);
  for (const int samples : {4, 16, 64}) {
    const PathTracedImage image = trace_paths(room(), inside_view(), 24, 18, 1, with_bounces(2, samples));
    const double error = difference(image.image, truth);
    EXPECT_GT(image.noise, 0.7 * error) << samples;
    EXPECT_LT(image.noise, 1.5 * error) << samples << ": halves are stratified less than the whole";
  }
}

TEST(PathTracer, StopsEarlyWhereItIsEasy) {
  Scene scene = floor_scene();
  scene.background.color = glm::vec3(0.5f);
  PathTracerOptions options = with_bounces(1, 1024);
  options.noise = 0.5;
  const PathTracedImage easy = trace_paths(scene, top_view(3), 16, 16, 1, options);
  EXPECT_EQ(easy.rays[2].rays, 16u * 16 * 16) << "sixteen paths are the least that is looked at";
  const PathTracedImage hard = trace_paths(room(), inside_view(), 16, 16, 1, options);
  EXPECT_GT(hard.rays[2].rays, 2 * easy.rays[2].rays);
  EXPECT_LT(hard.noise, options.noise);
}

TEST(PathTracer, TracesAllSamplesOtherwise) {
  Scene scene = floor_scene();
  scene.background.color = glm::vec3(0.5f);
  const PathTracedImage image = trace_paths(scene, top_view(3), 20, 7, 1, with_bounces(1, 99));
  EXPECT_EQ(image.rays[0].rays, 140u);
  EXPECT_EQ(image.rays[2].rays, 140u * 100) << "an even number";
  EXPECT_EQ(image.rays[2].name, "diffuse");
}

}  // namespace
}  // namespace lightbench
