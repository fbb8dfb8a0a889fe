#include "renderer/caustics/water_view.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderer/paths/path_scene.h"
#include "renderer/rays.h"
#include "scene/water.h"
#include "tests/renderer/caustics/water_scenes.h"

namespace lightbench {
namespace {

using namespace test;

constexpr int kWidth = 160, kHeight = 120;

FrameResult drawn(const Scene& scene, const View& view) {
  RenderSetup setup;
  setup.technique = "caustics";
  setup.width = kWidth;
  setup.height = kHeight;
  setup.buffers = {"through"};
  setup.params = {{"method", std::string("hit")}, {"map_size", 64LL}};
  return render(scene, view, setup);
}

/// Where a ray of the camera meets the water.
std::optional<glm::dvec3> on_water(const Scene& scene, const glm::dvec3& origin,
                                   const glm::dvec3& direction) {
  const Water& water = *scene.water;
  double way = (double(water.height) - origin.y) / direction.y;
  for (int i = 0; i < 20; ++i) {
    const glm::dvec3 p = origin + way * direction;
    way += (water_level(water, {p.x, p.z}, 0) - p.y) / direction.y;
  }
  const glm::dvec3 p = origin + way * direction;
  const bool inside = p.x > double(water.min.x) && p.x < double(water.max.x) && p.z > double(water.min.y) &&
                      p.z < double(water.max.y);
  return way > 0 && inside ? std::optional(p) : std::nullopt;
}

/// The share of the water's pixels that show another place than an exact ray meets, by more than a fiftieth
/// of a unit.
double wrong_share(const Scene& scene, const View& view) {
  const Image through = drawn(scene, view).buffers.at("through");
  const SceneRays rays(scene);
  const PathCamera camera(view.camera, kWidth, kHeight);
  int water = 0, wrong = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const glm::dvec3 direction(camera.direction(x, y));
      const auto surface = on_water(scene, glm::dvec3(camera.position()), direction);
      if (!surface) continue;
      const auto ray = refracted(direction, water_normal(*scene.water, {surface->x, surface->z}, 0),
                                 1 / double(scene.water->ior));
      const auto hit = rays.closest_hit(glm::vec3(*surface), glm::vec3(*ray));
      if (!hit) continue;
      const glm::dvec3 met = *surface + double(hit->distance) * *ray;
      const auto pixel = through.pixel(x, y);
      ++water;
      wrong += glm::distance(met, glm::dvec3(pixel[0], pixel[1], pixel[2])) > 0.02;
    }
  EXPECT_GT(water, kWidth * kHeight / 2);
  return double(wrong) / water;
}

TEST(GlWaterView, ShowsWhatRefractedRaysMeet) {
  const Scene scene = ball_in_waves();
  for (const double degrees : {35, 50, 70, 90})
    EXPECT_LT(wrong_share(scene, looking_down(degrees)), 0.01) << degrees;
}

TEST(GlWaterView, TheSurfaceReflectsTheBackgroundAndDarkensWhatIsBelow) {
  Scene scene = pool_scene({0, -1, 0});
  scene.background.color = {0.5f, 0, 0};
  scene.water->absorption = {0, 0.2f, 0};
  View view = top_view(6);
  view.camera.fov = 0.2f;
  const Image image = drawn(scene, view).image;
  const auto pixel = image.pixel(kWidth / 2, kHeight / 2);
  const double reflected = std::pow(0.333 / 2.333, 2), way = 2;
  // The light comes down through two units of water, and goes up through them.
  EXPECT_NEAR(double(pixel[0]), 0.8 * (1 - reflected) + 0.5 * reflected, 2e-3);
  EXPECT_NEAR(double(pixel[1]), 0.8 * std::exp(-0.2 * 2 * way) * (1 - reflected), 2e-3);
}

TEST(GlWaterView, FromBelowASteepRaySeesTheSkyAndAFlatOneTheFloor) {
  Scene scene = pool_scene({0, -1, 0});
  scene.background.color = {0, 0, 1};
  scene.water->ambient = {0.5f, 0, 0};
  View view = top_view(1);
  view.camera.look_at = {0, 2, 0};
  view.camera.fov = 0.2f;
  const Image up = drawn(scene, view).image;
  EXPECT_GT(up.pixel(kWidth / 2, kHeight / 2)[2], 0.95f);
  view.camera.look_at = {1, 1.85f, 0};  // just beyond the angle of total reflection
  view.camera.up = {0, 1, 0};
  const Image aside = drawn(scene, view).image;
  EXPECT_NEAR(double(aside.pixel(kWidth / 2, kHeight / 2)[0]), 0.8 * 0.5, 1e-3) << "the floor, reflected";
  EXPECT_EQ(aside.pixel(kWidth / 2, kHeight / 2)[2], 0);
}

}  // namespace
}  // namespace lightbench
