#include "scene/nearest_surface.h"

#include <gtest/gtest.h>

#include "scene/raw_random.h"
#include "view_world.h"

namespace lightbench {
namespace {

using namespace test;

TEST(NearestSurface, IsAsFarAsASearchOfAllTriangles) {
  TestWorld world = furnished_room();
  for (int i = 0; i < 30; ++i)  // more than one group of triangles
    world.add(glm::vec3(float(i), 5, 0), glm::vec3(float(i) + 0.5f, 6, 1), Facing::outward);
  world.scene().entities[1].transform[3] = {0.5f, 0.25f, 0, 1};
  const NearestSurface surfaces(world.scene());
  RawRandom random(1);
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 p(random.point(world_bounds(world.scene())));
    // Both add up the same floats; only the last square root may differ.
    EXPECT_FLOAT_EQ(surfaces.distance(p, 100), distance_to_nearest_surface(world.scene(), p));
  }
}

TEST(NearestSurface, IsTheLimitWhereNothingIsNearer) {
  TestWorld world;
  world.add({0, 0, 0}, {1, 1, 1}, Facing::outward);
  const float limit = 0.1f;  // its square's root is another float
  EXPECT_EQ(NearestSurface(world.scene()).distance({5, 5, 5}, limit), limit);
  EXPECT_LT(NearestSurface(world.scene()).distance({1.05f, 0.5f, 0.5f}, limit), limit);
}

}  // namespace
}  // namespace lightbench
