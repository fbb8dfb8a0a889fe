#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "view_world.h"

namespace lightbench {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// What version 1 drew when its views were stored and published. jobs/FORMAT.md promises them for ever, so
// these numbers must never change, whatever else the generators learn.
TEST(Views1, AreThoseOfBefore) {
  const TestWorld world = furnished_room();
  const auto views = draw_random_views(world.scene(), draw(3, 7, 1), world.rays());
  EXPECT_EQ(views[0].camera.position, glm::vec3(-0.6884f, 0.8429f, -1.5844f));
  EXPECT_EQ(views[0].camera.look_at, glm::vec3(-0.0262f, 0.6924f, -1.0957f));
  EXPECT_EQ(views[1].camera.position, glm::vec3(0.0889f, 0.0491f, 1.5459f));
  EXPECT_EQ(views[1].camera.look_at, glm::vec3(-0.6162f, 0.2215f, 1.1299f));
  EXPECT_EQ(views[2].camera.position, glm::vec3(-1.9387f, 0.0669f, 1.3143f));
  EXPECT_EQ(views[2].camera.look_at, glm::vec3(-1.1108f, 0.1803f, 1.3554f));
}

TEST(Views1, AViewOfTheRoomIsValid) {
  EXPECT_EQ(why(furnished_room(), {-2.5f, 1.6f, 2}, {1, 0.8f, -1}, 1), "valid");
}

TEST(Views1, ACameraInsideASolidIsNotValid) {
  EXPECT_THAT(why(furnished_room(), {1.5f, 1, 1}, {0, 1, 0}, 1),
              StartsWith("the camera is inside something"));
}

TEST(Views1, ACameraBehindTheWallsIsNotValid) {
  TestWorld world = furnished_room();
  world.add({-20, -1, -20}, {20, -0.5f, 20}, Facing::outward);
  EXPECT_THAT(why(world, {0, 1.5f, 6}, {0, 1.5f, 0}, 1), HasSubstr("back faces"));
}

TEST(Views1, ACameraThatTouchesAWallIsNotValid) {
  EXPECT_THAT(why(furnished_room(), {2.995f, 1.5f, 0}, {0, 1, 0}, 1),
              HasSubstr("from the camera, nearer than"));
}

TEST(Views1, AViewOfTheSkyIsNotValid) {
  TestWorld world;
  world.add({-50, -1, -50}, {50, 0, 50}, Facing::outward).add({3, 0, 3}, {4, 2, 4}, Facing::outward);
  EXPECT_THAT(why(world, {0, 2, 0}, {5, 7, 0}, 1), HasSubstr("are background"));
}

TEST(Views1, AWallThatFillsThePictureIsNotValid) {
  EXPECT_THAT(why(furnished_room(), {0, 1.5f, 1.5f}, {0, 1.5f, 2.5f}, 1), HasSubstr("a single flat surface"));
}

TEST(Views1, AViewOfSomethingFarAwayOnlyIsNotValid) {
  TestWorld world;
  world.add({0, 0, 0}, {1, 1, 1}, Facing::outward).add({100, 0, 0}, {101, 1, 1}, Facing::outward);
  View view{"v", {}};
  view.camera.position = {-150, 120, -150};
  view.camera.look_at = {0.5f, 0.5f, 0.5f};
  view.camera.fov = 0.004f;
  EXPECT_EQ(why_view_is_invalid(world.scene(), view, kAspect, world.rays(), 1),
            "nothing is near enough in sight");
}

}  // namespace
}  // namespace lightbench
