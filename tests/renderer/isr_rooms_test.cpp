#include <cmath>

#include <gtest/gtest.h>

#include "tests/renderer/isr_scenes.h"

namespace lightbench {
namespace {

using namespace test;

/// A box, seen from inside or from outside.
enum class Sides { inner, outer };

void add_box(Scene& scene, const glm::vec3& low, const glm::vec3& high, Sides sides, int material) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 u(0), v(0);
    u[(axis + 1) % 3] = (high - low)[(axis + 1) % 3];
    v[(axis + 2) % 3] = (high - low)[(axis + 2) % 3];
    glm::vec3 far_corner = low;
    far_corner[axis] = high[axis];
    const bool inner = sides == Sides::inner;
    add_quad(scene, low, inner ? u : v, inner ? v : u, material);
    add_quad(scene, far_corner, inner ? v : u, inner ? u : v, material);
  }
}

/// A dark room, x from -6 on, and behind a wall at x = 0 a room in which everything glows with radiance 1.
Scene two_rooms(float thickness) {
  Scene scene;
  scene.name = "two rooms";
  scene.materials = {matte(glm::vec3(0.7f)), glowing(1)};
  add_box(scene, {-6, 0, -3}, {-thickness / 2, 3, 3}, Sides::inner, 0);
  add_box(scene, {thickness / 2, 0, -3}, {6, 3, 3}, Sides::inner, 1);
  return scene;
}

/// The same rooms with a slit in the wall, from floor to ceiling.
Scene rooms_with_a_slit() {
  Scene scene;
  scene.name = "rooms with a slit";
  scene.materials = {matte(glm::vec3(0.7f)), glowing(1)};
  add_box(scene, {-6, 0, -3}, {6, 3, 3}, Sides::inner, 0);
  add_box(scene, {-0.1f, 0, -3}, {0.1f, 3, 1.2f}, Sides::outer, 0);
  add_box(scene, {-0.1f, 0, 1.7f}, {0.1f, 3, 3}, Sides::outer, 0);
  add_quad(scene, {5.9f, 0, -3}, {0, 0, 6}, {0, 3, 0}, 1);
  return scene;
}

/// What preset `best` does.
Params best(const Params& more = {}) {
  Params params = bitmask({{"steps", 64LL},
                           {"guard_resolution", 1LL},
                           {"layers", 4LL},
                           {"layer_faces", "all"},
                           {"bounces", 2LL},
                           {"unknown", "ambient"}});
  for (const auto& [name, value] : more) params[name] = value;
  return params;
}

View at_the_wall() {
  return view_from({-5.1f, 1.6f, 0.3f}, {0, 1.3f, -0.2f}, 1.2f);
}
View along_the_wall() {
  return view_from({-0.4f, 1.55f, 1.1f}, {-0.3f, 1.2f, -2}, 1.2f);
}
View away_from_the_wall() {
  return view_from({-0.8f, 1.7f, -0.4f}, {-6, 1.2f, 0.3f}, 1.2f);
}

double mean_indirect(const Scene& scene, const View& view, const Params& params) {
  return mean_of(render_isr(scene, view, params).buffers.at("indirect"));
}

/// Half a step of 8-bit sRGB near black: what is below it is shown as black.
constexpr double kShownAsBlack = 0.5 / 255 / 12.92;

class GlIsrDarkRoom : public ::testing::TestWithParam<float> {};

TEST_P(GlIsrDarkRoom, GetsNoLightFromBehindItsWall) {
  for (auto* view : {at_the_wall, away_from_the_wall})
    EXPECT_LT(mean_indirect(two_rooms(GetParam()), view(), best()), kShownAsBlack);
}
INSTANTIATE_TEST_SUITE_P(Thicknesses, GlIsrDarkRoom, ::testing::Values(0.02f, 0.1f, 0.3f));

// Steps that are wider than a wall is high end somewhere beyond it, where its plane lies behind what it
// hides.
TEST(GlIsrRooms, WideStepsLetNoLightThrough) {
  EXPECT_LT(mean_indirect(two_rooms(0.1f), at_the_wall(), best({{"steps", 12LL}})), kShownAsBlack);
}

// Seen at a grazing angle the wall changes its distance within a step more than anything else.
TEST(GlIsrRooms, AWallBesideTheCameraLetsNoLightThrough) {
  EXPECT_LT(mean_indirect(two_rooms(0.1f), along_the_wall(), best()), kShownAsBlack);
}

Image path_traced(const Scene& scene, const View& view) {
  return render(scene, view,
                {.technique = "path_tracer", .params = {{"samples", 64LL}}, .width = 128, .height = 96})
      .image;
}

double mean_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) sum += std::abs(a.pixel(x, y)[0] - b.pixel(x, y)[0]);
  return sum / (double(a.width) * a.height);
}

// What the layers add is light that comes through the slit, not through the walls.
TEST(GlIsrRooms, FourLayersAreNoWorseThanOne) {
  const Scene scene = rooms_with_a_slit();
  for (auto* view : {at_the_wall, along_the_wall, away_from_the_wall}) {
    const Image truth = path_traced(scene, view());
    const auto error = [&](long long layers) {
      const Params params = best({{"layers", layers}, {"steps", 12LL}});
      return mean_difference(render_isr(scene, view(), params).image, truth);
    };
    EXPECT_LT(error(4), error(1));
  }
}

}  // namespace
}  // namespace lightbench
