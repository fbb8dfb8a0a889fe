#include "scene/views/light_reach.h"

#include <gtest/gtest.h>

#include "view_world.h"

namespace lightbench {
namespace {

using namespace test;

const glm::vec3 kUp(0, 1, 0);

// A floor at height 0, and a roof over the half where x is positive.
TestWorld half_roofed() {
  return TestWorld()
      .add({-5, -1, -5}, {5, 0, 5}, Facing::outward)
      .add({0, 3, -5}, {5, 3.2f, 5}, Facing::outward);
}

bool lit(const TestWorld& world, const glm::vec3& point, const glm::vec3& normal = kUp) {
  const ClosestHit rays = world.rays();
  return LightReach(world.scene(), rays).lit(point, normal);
}

TEST(LightReach, TheSunReachesWhatHasNoRoof) {
  const TestWorld world = half_roofed().add_sun({0, -1, 0});
  EXPECT_TRUE(lit(world, {-2, 0, 0}));
  EXPECT_FALSE(lit(world, {2, 0, 0}));
}

TEST(LightReach, ALampReachesWhatFacesIt) {
  const TestWorld world = half_roofed().add_light({2, 2, 0});
  EXPECT_TRUE(lit(world, {2, 0, 0}));
  EXPECT_FALSE(lit(world, {2, 3.2f, 0})) << "the roof is between";
  EXPECT_FALSE(lit(world, {2, 0, 0}, -kUp)) << "turned away";
}

TEST(LightReach, ALampThatFadesDoesNotReachFar) {
  TestWorld world = half_roofed().add_light({-2, 2, 0});
  world.scene().lights[0].attenuation.kind = Attenuation::Kind::inverse_square;
  EXPECT_TRUE(lit(world, {-2, 0, 0})) << "1/4";
  world.scene().lights[0].power = 0.04f;
  EXPECT_FALSE(lit(world, {-2, 0, 0})) << "0.01, half of what counts as lit";
}

TEST(LightReach, ASpotReachesOnlyItsCone) {
  TestWorld world = half_roofed().add_light({-2, 2, 0});
  Light& spot = world.scene().lights[0];
  spot.kind = LightKind::spot;
  spot.inner_angle = 0.3f;
  spot.outer_angle = 0.4f;
  EXPECT_TRUE(lit(world, {-2, 0, 0}));
  EXPECT_FALSE(lit(world, {-2, 0, 2})) << "45 degrees aside";
}

TEST(LightReach, SurfacesThatEmitCountWhereThereAreNoLights) {
  TestWorld world = half_roofed().add_quad({-1, 2, -1}, {1, 0, 0}, {0, 0, 1});
  Material lamp;
  lamp.emission = glm::vec3(10);
  world.scene().materials.push_back(lamp);
  world.scene().meshes.back().parts[0].material = 1;
  EXPECT_TRUE(lit(world, {-0.5f, 0, -0.5f}));
}

TEST(LightReach, TheSkyCountsWhereThereIsNothingElse) {
  TestWorld world = half_roofed();
  world.scene().background.color = glm::vec3(0.3f);
  EXPECT_TRUE(lit(world, {-2, 0, 0}));
  world.scene().background.lights = false;
  const ClosestHit rays = world.rays();
  EXPECT_FALSE(LightReach(world.scene(), rays).has_light());
}

}  // namespace
}  // namespace lightbench
