#include "renderer/frame_camera.h"

#include <cmath>

#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lightbench {
namespace {

constexpr float kAspect = 1.5f;

FrameCamera slanted_camera() {
  Camera camera;
  camera.position = {1, 2, 3};
  camera.look_at = {-4, 0.5f, 7};
  camera.fov = 0.9f;
  return frame_camera(camera, kAspect, {0.01f, 50.0f});
}

glm::dvec3 ndc(const FrameCamera& camera, const glm::dvec3& p) {
  const glm::dvec4 clip = camera.clip_from_world * glm::dvec4(p, 1);
  return glm::dvec3(clip) / clip.w;
}

TEST(FrameCamera, FarVectorsReachTheImageCorners) {
  const FrameCamera camera = slanted_camera();
  const glm::dvec3 lower_left = camera.position + camera.far_corner;
  const glm::dvec3 upper_right = lower_left + glm::dvec3(camera.far_u + camera.far_v);
  // Floats of size 50 carry about 4e-6.
  EXPECT_NEAR(ndc(camera, lower_left).x, -1, 1e-5);
  EXPECT_NEAR(ndc(camera, lower_left).y, -1, 1e-5);
  EXPECT_NEAR(ndc(camera, upper_right).x, 1, 1e-5);
  EXPECT_NEAR(ndc(camera, upper_right).y, 1, 1e-5);
}

TEST(FrameCamera, DepthIsReversed) {
  const FrameCamera camera = slanted_camera();
  const auto depth_at = [&](double distance) {
    return ndc(camera, glm::dvec3(camera.position) + distance * glm::dvec3(camera.frame.forward)).z;
  };
  EXPECT_NEAR(depth_at(0.01), 1.0, 1e-5);
  EXPECT_NEAR(depth_at(1.0), 0.01, 1e-7);
  EXPECT_GT(depth_at(1e6), 0.0);
}

TEST(FrameCamera, AWidenedCameraSeesTheSamePointsNearerToTheCentre) {
  const FrameCamera camera = slanted_camera();
  const glm::dvec3 corner = camera.position + camera.far_corner;
  EXPECT_NEAR(ndc(widened(camera, 1.5f), corner).x, -1 / 1.5, 1e-5);
  EXPECT_NEAR(ndc(widened(camera, 1.5f), corner).y, -1 / 1.5, 1e-5);
}

TEST(MayBeVisible, BoxesAroundBehindAndBeside) {
  const FrameCamera camera = slanted_camera();
  const auto box_at = [&](const glm::vec3& center) {
    Bounds box;
    box.add(center - 0.1f);
    box.add(center + 0.1f);
    return box;
  };
  const glm::vec3 forward = camera.frame.forward, right = camera.frame.right;
  EXPECT_TRUE(may_be_visible(box_at(camera.position), camera.clip_from_world));
  EXPECT_TRUE(may_be_visible(box_at(camera.position + 5.0f * forward), camera.clip_from_world));
  EXPECT_FALSE(may_be_visible(box_at(camera.position - 5.0f * forward), camera.clip_from_world));
  EXPECT_FALSE(
      may_be_visible(box_at(camera.position + 2.0f * forward + 9.0f * right), camera.clip_from_world));
}

RC_GTEST_PROP(MayBeVisible, ABoxWithAVisiblePointIsNeverDropped, ()) {
  const FrameCamera camera = slanted_camera();
  // Not quite to the edges, where rounding decides.
  const auto share = [] { return float(*rc::gen::inRange(1, 1000)) / 1000.0f; };
  const float z = 0.001f + share();
  const glm::vec3 seen =
      camera.position + (camera.far_corner + share() * camera.far_u + share() * camera.far_v) * z;
  Bounds box;
  box.add(seen - 10.0f * glm::vec3(share(), share(), share()));
  box.add(seen + 10.0f * glm::vec3(share(), share(), share()));
  RC_ASSERT(may_be_visible(box, camera.clip_from_world));
}

Bounds box_between(const glm::vec3& a, const glm::vec3& b) {
  Bounds box;
  box.add(a);
  box.add(b);
  return box;
}

TEST(PixelsOfBox, NoneBehindAllAroundAndFewForWhatIsSmall) {
  const FrameCamera camera = slanted_camera();
  const glm::ivec2 picture(300, 200);
  const auto pixels_at = [&](const glm::vec3& center, float half) {
    return pixels_of_box(box_between(center - half, center + half), camera.clip_from_world, picture);
  };
  const glm::vec3 forward = camera.frame.forward;
  EXPECT_EQ(pixels_at(camera.position - 5.0f * forward, 0.1f).size, glm::ivec2(0));
  EXPECT_EQ(pixels_at(camera.position, 0.1f).size, picture);
  const PixelRect small = pixels_at(camera.position + 10.0f * forward, 0.01f);
  EXPECT_LE(small.size.x, 6);
  EXPECT_LE(small.size.y, 6);
  EXPECT_EQ(small.low + small.size / 2, picture / 2);
}

RC_GTEST_PROP(PixelsOfBox, HoldTheCornersOfWhatIsInSight, ()) {
  const FrameCamera camera = slanted_camera();
  const glm::ivec2 picture(300, 200);
  const auto share = [] { return float(*rc::gen::inRange(1, 1000)) / 1000.0f; };
  const auto seen = [&](float z) {
    return camera.position + (camera.far_corner + share() * camera.far_u + share() * camera.far_v) * z;
  };
  const glm::vec3 a = seen(share()), b = seen(share());
  const PixelRect pixels = pixels_of_box(box_between(a, b), camera.clip_from_world, picture);
  for (const glm::vec3& corner : {a, b}) {
    const glm::dvec2 pixel = (glm::dvec2(ndc(camera, corner)) + 1.0) / 2.0 * glm::dvec2(picture);
    RC_ASSERT(glm::all(glm::lessThanEqual(glm::dvec2(pixels.low), pixel)));
    RC_ASSERT(glm::all(glm::lessThanEqual(pixel, glm::dvec2(pixels.low + pixels.size))));
  }
}

}  // namespace
}  // namespace lightbench
