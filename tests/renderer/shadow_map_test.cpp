#include "renderer/shadow_map.h"

#include <gtest/gtest.h>

#include "tests/renderer/render_scene.h"

namespace lightbench {
namespace {

using test::add_quad;
using test::directional_light;
using test::floor_point;
using test::floor_scene;
using test::point_light;
using test::render;
using test::top_view;

constexpr int kWidth = 160;
constexpr int kHeight = 120;

// A floor with a plate of 1 x 1 floating one unit above it, seen from below the plate's height.
Scene plate_scene(const Light& light) {
  Scene scene = floor_scene();
  add_quad(scene, {-0.5f, 1, 0.5f}, {1, 0, 0}, {0, 0, -1});
  scene.lights = {light};
  return scene;
}

View low_view() {
  return top_view(0.99f);
}

Image shadow_of(const Scene& scene, const std::string& mode, const View& view,
                std::map<std::string, ParamValue> params = {}) {
  test::RenderSetup setup;
  setup.width = kWidth;
  setup.height = kHeight;
  setup.params = std::move(params);
  setup.shadow_size = 2048;
  setup.params["shadows"] = mode;
  setup.buffers = {"shadow"};
  return render(scene, view, setup).buffers.at("shadow");
}

// Pixels whose point on the floor is on the wrong side of the shadow's edge |x| = |z| = half around `center`,
// by more than `margin`.
int wrong_pixels(const Image& visible, const View& view, float half, const glm::vec3& center, float margin) {
  int wrong = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const glm::vec3 p = floor_point(view, kWidth, kHeight, x, y) - center;
      const float outside = std::max(std::abs(p.x), std::abs(p.z)) - half;
      if (std::abs(outside) < margin) continue;
      wrong += visible.pixel(x, y)[0] != (outside > 0 ? 1.0f : 0.0f);
    }
  return wrong;
}

// Two texels of the narrowest map used: 2048 over about 1.5 units.
constexpr float kEdge = 2e-3f;

TEST(GlShadow, ADirectionalLightsShadowIsWhereItHasToBe) {
  const Scene scene = plate_scene(directional_light({0.2f, -1, 0.1f}));
  const View view = low_view();
  EXPECT_EQ(wrong_pixels(shadow_of(scene, "hard", view), view, 0.5f, {0.2f, 0, 0.1f}, kEdge), 0);
}

TEST(GlShadow, APointLightsShadowIsWhereItHasToBe) {
  const Scene scene = plate_scene(point_light({0, 4, 0}));
  const View view = low_view();
  EXPECT_EQ(wrong_pixels(shadow_of(scene, "hard", view), view, 0.5f * 4 / 3, {0, 0, 0}, kEdge), 0);
}

TEST(GlShadow, ASpotsShadowIsWhereItHasToBe) {
  Light spot = point_light({0, 4, 0});
  spot.kind = LightKind::spot;
  spot.direction = {0, -1, 0};
  spot.inner_angle = 0.6f;
  spot.outer_angle = 0.7f;
  const View view = low_view();
  EXPECT_EQ(wrong_pixels(shadow_of(plate_scene(spot), "hard", view), view, 0.5f * 4 / 3, {0, 0, 0}, kEdge),
            0);
}

TEST(GlShadow, WithoutShadowsAllIsVisible) {
  const Scene scene = plate_scene(point_light({0, 4, 0}));
  for (const float value : shadow_of(scene, "none", low_view()).data) ASSERT_EQ(value, 1.0f);
}

TEST(GlShadow, FilteredShadowsAreSoftOnlyAtTheEdge) {
  const Scene scene = plate_scene(point_light({0, 4, 0}));
  const View view = low_view();
  const std::map<std::string, ParamValue> coarse{{"shadow_size", 64LL}, {"pcf_radius", 2LL}};
  const Image visible = shadow_of(scene, "pcf", view, coarse);
  // 64 texels over about 1.5 units; three of them to each side.
  EXPECT_EQ(wrong_pixels(visible, view, 0.5f * 4 / 3, {0, 0, 0}, 0.1f), 0);
  int soft = 0;
  for (const float value : visible.data) soft += value > 0.05f && value < 0.95f;
  EXPECT_GT(soft, 100);
}

TEST(GlShadow, ExponentialVisibilityFollowsTheFormula) {
  // Straight below the light n.l is 1; the depths 3 and 4 are divided by the largest distance that is seen,
  // which is that of the picture's corner.
  const Scene scene = plate_scene(point_light({0, 4, 0}));
  const float range = glm::distance(glm::vec3(0, 4, 0), floor_point(low_view(), kWidth, kHeight, 0, 0));
  const Image visible = shadow_of(scene, "esm", low_view());
  EXPECT_NEAR(visible.pixel(kWidth / 2, kHeight / 2)[0], std::exp(-90.0f * 1 / range), 0.01f);
}

TEST(GlShadow, PlanesDoNotShadowThemselvesAtAnyAngle) {
  for (const float height : {0.05f, 0.5f, 5.0f}) {
    Scene scene = floor_scene();
    scene.lights = {point_light({0.3f, height, 0.2f}), directional_light({1, -height / 5, 0.3f})};
    for (const float value : shadow_of(scene, "hard", top_view(3), {{"shadow_size", 128LL}}).data)
      ASSERT_EQ(value, 1.0f) << height;
  }
}

TEST(GlShadow, AClosedThinBoxLetsNoLightIn) {
  Scene scene = floor_scene();
  // Walls and a lid of no thickness, all meeting at their edges; the view is inside.
  add_quad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 1, 0});
  add_quad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 1, 0});
  add_quad(scene, {-1, 0, -1}, {0, 0, 2}, {0, 1, 0});
  add_quad(scene, {1, 0, -1}, {0, 0, 2}, {0, 1, 0});
  add_quad(scene, {-1, 1, -1}, {2, 0, 0}, {0, 0, 2});
  View view = top_view(0.9f);
  view.camera.fov = 2.4f;
  view.camera.position += glm::vec3(0.013f, 0, 0.007f);  // no pixel's centre on the edges
  for (const Light& light :
       {point_light({3, 2, 1.5f}), point_light({0, 5, 0}), directional_light({1, -0.5f, 0.4f})}) {
    scene.lights = {light};
    int lit = 0;
    for (const float value : shadow_of(scene, "hard", view).data) lit += value > 0;
    // Texels and the bias let light pass within a thousandth of a unit of the edges where walls meet: of the
    // 500 pixels along them, whose width is 0.02 units and more, one in twenty.
    EXPECT_LE(lit, 25);
  }
}

TEST(GlShadow, CutOutsCastCutOutShadows) {
  Scene scene = plate_scene(directional_light({0, -1, 0}));
  Texture mask;
  mask.pixels = Image8(2, 1, 4, 255);
  mask.pixels.data[3] = 0;  // the left half (-x) is away
  scene.textures = {mask};
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].cutout_texture = 0;
  scene.meshes[1].parts[0].material = 1;
  const Image visible = shadow_of(scene, "hard", low_view());
  EXPECT_EQ(visible.pixel(kWidth / 2 - 10, kHeight / 2)[0], 1.0f);
  EXPECT_EQ(visible.pixel(kWidth / 2 + 10, kHeight / 2)[0], 0.0f);
}

TEST(GlShadow, WhatTheCameraDoesNotSeeCastsShadowsToo) {
  Scene scene = plate_scene(directional_light({1, -0.25f, 0}));
  scene.entities[1].transform[3].x = -4;  // far beside the picture; its shadow falls on the middle
  const Image visible = shadow_of(scene, "hard", low_view());
  EXPECT_EQ(visible.pixel(kWidth / 2, kHeight / 2)[0], 0.0f);
}

TEST(ShadowViews, AFittedViewSpansTheExtentWithItsMargin) {
  LightBlock block = light_block(point_light({1, 2, 3}), 1);
  Bounds bounds;
  bounds.add({-5, -5, -5});
  bounds.add({5, 5, 5});
  place_shadow_views(block, point_light({1, 2, 3}), bounds);
  ViewExtent extent;
  extent.min = {-0.5f, 0.25f};
  extent.max = {0.0f, 0.75f};
  fit_view(block.views[0], extent, 1e-5f, 100, 10);
  const glm::dmat4 clip = shadow_clip_matrix(block, 0, ShadowProjection::cube);
  // Face +x: right is -z, up is y. The extent's corner at distance 2.
  const glm::dvec4 corner = clip * glm::dvec4(1 + 2, 2 + 2 * 0.25, 3 + 2 * 0.5, 1);
  EXPECT_NEAR(corner.x / corner.w, -0.8, 1e-6);  // ten of a hundred texels on each side
  EXPECT_NEAR(corner.y / corner.w, -0.8, 1e-6);
}

TEST(ShadowViews, AnUnseenViewIsMarked) {
  LightBlock block = light_block(point_light({0, 0, 0}), 1);
  fit_view(block.views[2], ViewExtent{}, 1e-5f, 100, 2);
  EXPECT_EQ(block.views[2].forward.w, 0.0f);
}

TEST(ShadowViews, WideSpotsNeedACube) {
  Light spot = point_light({0, 0, 0});
  spot.kind = LightKind::spot;
  spot.outer_angle = 0.5f;
  EXPECT_EQ(shadow_projection(spot), ShadowProjection::perspective);
  spot.outer_angle = 1.4f;
  EXPECT_EQ(shadow_projection(spot), ShadowProjection::cube);
}

}  // namespace
}  // namespace lightbench
