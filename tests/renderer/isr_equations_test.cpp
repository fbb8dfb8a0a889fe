#include <cmath>

#include <gtest/gtest.h>

#include "tests/renderer/isr_scenes.h"

/// Equations 25 to 29 of the image-space radiosity thesis by numbers that were worked out by hand, on
/// pictures of 3x3 coarse pixels whose edge is 1 at distance 1, so that their rays are (-1|0|1, -1|0|1, -1).
///
/// The camera stands at 0 and looks along -z, at a floor at y = -1 and a wall at z = -2. The lowest row shows
/// the floor at depth 1, the others show the wall.
namespace lightbench {
namespace {

using namespace test;

constexpr double kHalves =
    2e-3;  // albedo, radiance and light are half floats: four roundings of at most 2^-11

constexpr float kFloorAlbedo = 0.8f;
constexpr float kWallAlbedo = 0.5f;

Scene floor_and_wall(float floor_mask, float wall_mask, float floor_front = 1, float wall_z = -2) {
  Scene scene;
  scene.name = "floor_and_wall";
  scene.materials = {matte(glm::vec3(kFloorAlbedo)), matte(glm::vec3(kWallAlbedo))};
  scene.materials[0].reflectance = floor_mask;
  scene.materials[1].reflectance = wall_mask;
  add_quad(scene, {-10, -1, floor_front}, {20, 0, 0}, {0, 0, wall_z - floor_front}, 0);
  add_quad(scene, {-10, -1, wall_z}, {20, 0, 0}, {0, 20, 0}, 1);
  return scene;
}

/// The eight coarse pixels around each, without blur.
Params printed(const Params& more = {}) {
  Params params{{"weighting", "paper"},  {"source", "albedo"},    {"pattern", "grid"},
                {"samples", 8LL},        {"rotation", "none"},    {"form_factor_limit", 1e6},
                {"blur", "none"},        {"energy_bound", false}, {"downsampling", "mean"},
                {"upsampling", "depth"}, {"background", false},   {"resolution", 1LL}};
  for (const auto& [name, value] : more) params[name] = value;
  return params;
}

FrameResult render_printed(const Scene& scene, const Params& params, int size = 3) {
  const View view = view_from({0, 0, 0}, {0, 0, -1}, 2 * std::atan(1.5f));
  return render_isr(scene, view, params, size, size);
}

// The floor at P = (0, -1, -1) sees the wall at X = (-2|0|2, 0, -2), whose patches have the area 1 * 2^2 = 4:
//   X = ( 0, 0, -2): PX = ( 0, 1, -1), r^2 = 2, both cosines 1/sqrt(2): F = (1/2) 4 / (2 pi) = 1 / pi
//   X = (+-2, 0, -2): PX = (+-2, 1, -1), r^2 = 6, both cosines 1/sqrt(6): F = (1/6) 4 / (6 pi) = 1 / (9 pi)
// L = rho (2 pi / 8) (1 + 2/9) / pi * 0.5 = rho * 11/72. The floor does not see itself.
TEST(GlIsrEquations, Eq25LightsTheFloorByTheWall) {
  const FrameResult result = render_printed(floor_and_wall(0.4f, 1), printed());
  const double expected = 0.4 * 11 / 72;
  EXPECT_NEAR(result.buffers.at("indirect").pixel(1, 2)[0], expected, kHalves * expected);
}

// The wall at P = (0, 0, -2) sees the floor at X = (-1|0|1, -1, -1), whose patches have the area 1:
//   X = ( 0, -1, -1): PX = ( 0, -1, 1), r^2 = 2: F = (1/2) / (2 pi) = 1 / (4 pi)
//   X = (+-1, -1, -1): PX = (+-1, -1, 1), r^2 = 3: F = (1/3) / (3 pi) = 1 / (9 pi)
// L = rho (2 pi / 8) (1/4 + 2/9) / pi * 0.8 = rho * 17/180.
TEST(GlIsrEquations, Eq25LightsTheWallByTheFloor) {
  const FrameResult result = render_printed(floor_and_wall(1, 0.25f), printed());
  const double expected = 0.25 * 17 / 180;
  EXPECT_NEAR(result.buffers.at("indirect").pixel(1, 1)[0], expected, kHalves * expected);
}

// Spheres of half a pixel's size at their depth have the radius 1 on the wall. From P = (0, -1, -1):
//   X = ( 0, 0, -2): |PX|^2 = 2, cosine 0.70711: (1 - sqrt(1 - 1/2)) * 0.70711 = 0.29289 * 0.70711 = 0.20711
//   X = (+-2, 0, -2): |PX|^2 = 6, cosine 0.40825: (1 - sqrt(1 - 1/6)) * 0.40825 = 0.08713 * 0.40825 = 0.03557
// SSAO = (2 pi / 8) (0.20711 + 2 * 0.03557) = 0.78540 * 0.27825 = 0.21854.
constexpr double kOpenness = 1 - 0.21854;
const Params kHalfPixels{{"occluder_radius", 0.5}, {"occlusion_radius", std::sqrt(2.0) / 3}, {"k_isr", 0.0}};

Params occluded(double k_ssao) {
  Params params = printed(kHalfPixels);
  params["k_ssao"] = k_ssao;
  return params;
}

TEST(GlIsrEquations, Eq26OccludesTheFloorByTheWall) {
  const FrameResult result = render_printed(floor_and_wall(1, 1), occluded(1));
  EXPECT_NEAR(result.buffers.at("occlusion").pixel(1, 2)[0], kOpenness, kHalves);
}

// Eq. 29: the sun straight above gives the floor its albedo 0.8; of that it keeps min(0.78146 + 1 - k, 1).
TEST(GlIsrEquations, Eq29DarkensDirectLight) {
  Scene scene = floor_and_wall(1, 1);
  scene.lights = {directional_light({0, -1, 0})};
  const auto floor = [&](double k_ssao) {
    return render_printed(scene, occluded(k_ssao)).image.pixel(1, 2)[0];
  };
  EXPECT_NEAR(floor(0.9), 0.8 * 0.88146, kHalves);
  EXPECT_NEAR(floor(0.1), 0.8, kHalves);
}

// From here on the frame has 6x6 pixels. The two rows of pixels that a lowest coarse pixel is made of look
// down by 1.25 and 0.75 and meet the floor at the depths 1/1.25 = 4/5 and 1/0.75 = 4/3, whose mean is 16/15.
// So its patch lies on the ray through its middle at (x, -1, -1) * 16/15, above the floor or not, and has the
// area (16/15)^2.

// The lowest coarse pixel in the middle, P = (0, -16/15, -16/15), sees the wall:
//   X = ( 0, 0, -2): PX = ( 0, 16, -14) / 15, r^2 = 452/225: F pi = (224/225) 4 / (452/225)^2 = 0.98677
//   X = (+-2, 0, -2): PX = (+-30, 16, -14) / 15, r^2 = 1352/225: F pi = (224/225) 4 / (1352/225)^2 = 0.11029
// L = (2/8) (0.98677 + 2 * 0.11029) * 0.5 = 0.15092. To its left it is that at (-16/15, -16/15, -16/15),
// where the wall's third patch is out of the kernel's reach:
//   X = ( 0, 0, -2): PX = (16, 16, -14) / 15, r^2 = 708/225: F pi = (224/225) 4 / (708/225)^2 = 0.40218
//   X = (-2, 0, -2): PX = (-14, 16, -14) / 15, r^2 = 648/225: F pi = (224/225) 4 / (648/225)^2 = 0.48011
// L = (2/8) (0.40218 + 0.48011) * 0.5 = 0.11029.
//
// The pixel (2, 5) lies a quarter of a coarse pixel left of the middle one's centre and a quarter below;
// beyond the picture's edge the lowest row goes on. So it takes 1/4 of the left and 3/4 of the middle one:
// 0.14076.
TEST(GlIsrEquations, DepthsAreAveragedAndReachTheirPixelsBilinearly) {
  const FrameResult result = render_printed(floor_and_wall(1, 0), printed({{"resolution", 2LL}}), 6);
  EXPECT_NEAR(result.buffers.at("indirect").pixel(2, 5)[0], 0.14076, kHalves * 0.14076);
}

// The wall's coarse pixels are lit by the floor's:
//   P = (0, 0, -2): X = ( 0, -16, -16) / 15: PX = (0, -16, 14) / 15, r^2 = 452/225:
//                     F pi = (224/225) (256/225) / (452/225)^2 = 0.28068
//                   X = (+-16, -16, -16) / 15: r^2 = 708/225:
//                     F pi = (224/225) (256/225) / (708/225)^2 = 0.11440
//                   L = (2/8) (0.28068 + 2 * 0.11440) * 0.8 = 0.10190
//   P = (2, 0, -2): X = ( 0, -16, -16) / 15: PX = (-30, -16, 14) / 15, r^2 = 1352/225: F pi = 0.03137
//                   X = (16, -16, -16) / 15: PX = (-14, -16, 14) / 15, r^2 = 648/225: F pi = 0.13656
//                   L = (2/8) (0.03137 + 0.13656) * 0.8 = 0.03359
// The floor's own get nothing, with a mask of 0.
//
// Eq. 27 and 28 for the floor's pixel at the ray (0.25, -0.75, -1), depth 4/3. It lies at (x, y) = (1/4, 1/4)
// between the floor's coarse pixels below it, depth 16/15, and the wall's above it, depth 2. With epsilon =
// 0.05 * 4/3 = 1/15:
//   floor: w^z = 1 / (1/15 + 4/15) = 3;       w^b = 9/16, 3/16: w' = 1.68750, 0.56250
//   wall:  w^z = 1 / (1/15 + 10/15) = 15/11;  w^b = 3/16, 1/16: w' = 0.25568, 0.08523
// Their sum is 2.59091, so L = (0.25568 * 0.10190 + 0.08523 * 0.03359) / 2.59091 = 0.011161.
Params half_size(const Params& more = {}) {
  Params params = printed({{"resolution", 2LL}, {"upsample_epsilon", 0.05}});
  for (const auto& [name, value] : more) params[name] = value;
  return params;
}

TEST(GlIsrEquations, Eq27And28WeighByDepth) {
  const FrameResult result = render_printed(floor_and_wall(0, 1), half_size(), 6);
  EXPECT_NEAR(result.buffers.at("indirect").pixel(3, 4)[0], 0.011161, kHalves * 0.011161);
}

// The wall does not lie in the floor's plane, so nothing of it reaches the floor.
TEST(GlIsrEquations, WeightsByPlaneTakeNothingOfTheWall) {
  const FrameResult result = render_printed(floor_and_wall(0, 1), half_size({{"upsampling", "plane"}}), 6);
  EXPECT_EQ(result.buffers.at("indirect").pixel(3, 4)[0], 0);
}

// The floor begins at z = -1: of the lowest coarse pixels only the upper pixels show it, at depth 4/3.
//   P = (0, -4/3, -4/3):
//     X = (0, 0, -2): PX = (0, 4, -2) / 3, r^2 = 20/9: F pi = (8/9) 4 / (20/9)^2 = 0.72
//     X = (+-2, 0, -2): PX = (+-6, 4, -2) / 3, r^2 = 56/9: F pi = (8/9) 4 / (56/9)^2 = 0.091837
//     L = (2/8) (0.72 + 2 * 0.091837) * 0.5 = 0.112959
//   P = (-4/3, -4/3, -4/3):
//     X = (0, 0, -2): PX = (4, 4, -2) / 3, r^2 = 4: F pi = (8/9) 4 / 4^2 = 0.222222
//     X = (-2, 0, -2): PX = (-2, 4, -2) / 3, r^2 = 24/9: F pi = (8/9) 4 / (24/9)^2 = 0.5
//     L = (2/8) (0.222222 + 0.5) * 0.5 = 0.090278
// The wall has a mask of 0 and gets nothing. The pixel (2, 4) has the depth of the floor's coarse pixels, so
// that their w^z are 1/epsilon = 15; the wall's are 15/11. Its w' are 15 (9/16) and 15 (3/16) for the floor,
// 15/11 (3/16) and 15/11 (1/16) for the wall, in all 11.59091: L = (8.4375 * 0.112959 + 2.8125 * 0.090278)
// / 11.59091 = 0.104132.
TEST(GlIsrEquations, TheBackgroundHasNoShareInTheMean) {
  const FrameResult result = render_printed(floor_and_wall(1, 0, -1), half_size(), 6);
  EXPECT_NEAR(result.buffers.at("indirect").pixel(2, 4)[0], 0.104132, kHalves * 0.104132);
}

// The wall stands at z = -1, so that the lowest coarse pixels are half floor, at depth 0.8, and half wall, at
// depth 1. Their patches lie at (x, -1, -1) * 0.9 with the normal (0, 1, 1) / sqrt(2) and the mask (0.4 + 1)
// / 2 = 0.7. The wall's patches above them have the area 1.
//   P = (0, -0.9, -0.9):
//     X = (0, 0, -1): PX = (0, 0.9, -0.1), r^2 = 0.82:
//       F pi = (0.8 / sqrt(2)) 0.1 / 0.82^2 = 0.0565685 / 0.82^2 = 0.084129
//     X = (+-1, 0, -1): PX = (+-1, 0.9, -0.1), r^2 = 1.82: F pi = 0.0565685 / 1.82^2 = 0.017078
//     L = 0.7 (2/8) (0.084129 + 2 * 0.017078) * 0.5 = 0.010350
//   P = (0.9, -0.9, -0.9):
//     X = (0, 0, -1): PX = (-0.9, 0.9, -0.1), r^2 = 1.63: F pi = 0.0565685 / 1.63^2 = 0.021291
//     X = (1, 0, -1): PX = (0.1, 0.9, -0.1), r^2 = 0.83: F pi = 0.0565685 / 0.83^2 = 0.082114
//     L = 0.7 (2/8) (0.021291 + 0.082114) * 0.5 = 0.009048
// The pixel (3, 5) takes 3/4 of the first and 1/4 of the second.
TEST(GlIsrEquations, NormalsAndMasksAreAveraged) {
  const FrameResult result = render_printed(floor_and_wall(0.4f, 1, 1, -1), half_size(), 6);
  EXPECT_NEAR(result.buffers.at("indirect").pixel(3, 5)[0], 0.010024, kHalves * 0.010024);
}

}  // namespace
}  // namespace lightbench
