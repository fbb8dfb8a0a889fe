#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/nearest_surface.h"
#include "scene/views/scene_scale.h"
#include "view_world.h"

namespace lightbench {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TestWorld lit_room() {
  return furnished_room().add_light({0, 2.8f, 0});
}

std::vector<View> drawn(const TestWorld& world, int count, std::uint64_t seed = 1) {
  return draw_random_views(world.scene(), draw(count, seed, 2), world.rays());
}

glm::vec3 direction_of(const View& view) {
  return glm::normalize(view.camera.look_at - view.camera.position);
}

// jobs/FORMAT.md promises the views of version 2 too, on every platform.
TEST(Views2, AreTheSameOnEveryPlatform) {
  const auto views = drawn(lit_room(), 2, 7);
  EXPECT_EQ(views[0].camera.position, glm::vec3(-2.58f, 1.6f, -2.0266f));
  EXPECT_EQ(views[0].camera.look_at, glm::vec3(-1.9379f, 1.313f, -1.5734f));
  EXPECT_EQ(views[1].camera.position, glm::vec3(2.5557f, 1.6f, 0.3191f));
  EXPECT_EQ(views[1].camera.look_at, glm::vec3(1.8135f, 1.2235f, 0.4054f));
}

TEST(Views2, KeepClearOfAllSurfacesOfARoom) {
  const TestWorld world = lit_room();
  const float clearance = 0.03f * world_bounds(world.scene()).diagonal();  // 0.25: more than 0.2
  for (const View& view : drawn(world, 12))
    EXPECT_GE(distance_to_nearest_surface(world.scene(), view.camera.position), clearance) << view.name;
}

TEST(Views2, StandAtTheHeightOfEyes) {
  int standing = 0;
  for (const View& view : drawn(lit_room(), 10))
    standing += std::abs(view.camera.position.y - 1.6f) < 1e-3f;  // positions are rounded
  EXPECT_GE(standing, 7) << "the others are where a table counts as the floor";
}

TEST(Views2, StandInProportionToARoomOfUnknownUnit) {
  for (const float scale : {1e-3f, 100.0f}) {
    TestWorld world;
    world.add(scale * glm::vec3(-3, 0, -2), scale * glm::vec3(3, 3, 2), Facing::inward)
        .add(scale * glm::vec3(0, 0, 0), scale * glm::vec3(0.5f, 0.3f, 0.5f), Facing::outward);
    for (const View& view : drawn(world, 5))
      EXPECT_NEAR(view.camera.position.y, scale * 1.8f, scale * 0.35f)
          << "0.6 of 3, over the floor or the box";
  }
}

TEST(Views2, AreSpreadOverTheRoom) {
  const auto views = drawn(lit_room(), 8);
  Bounds reached;
  for (const View& view : views) reached.add(view.camera.position);
  EXPECT_GT(reached.max.x - reached.min.x, 3) << "half of the room";
  EXPECT_GT(reached.max.z - reached.min.z, 2.5f);
}

TEST(Views2, OfOnePlaceLookElsewhere) {
  TestWorld world;  // so small that there is hardly more than one place to stand
  world.add({0, 0, 0}, {1.2f, 2.5f, 1.2f}, Facing::inward);
  const auto views = drawn(world, 2);
  EXPECT_LT(glm::dot(direction_of(views[0]), direction_of(views[1])), 0.7f);
}

TEST(Views2, LookAtASingleObjectFromAround) {
  TestWorld world;
  world.add({0, 0, 0}, {1, 1, 1}, Facing::outward).add({0.4f, 1, 0.4f}, {0.6f, 1.5f, 0.6f}, Facing::outward);
  world.add_sun({-0.5f, -1, -0.35f});
  for (const View& view : drawn(world, 6)) {
    EXPECT_GT(glm::distance(view.camera.position, {0.5f, 0.75f, 0.5f}), 1.0f);
    EXPECT_GT(
        glm::dot(direction_of(view), glm::normalize(glm::vec3(0.5f, 0.75f, 0.5f) - view.camera.position)),
        0.99f);
  }
}

TEST(Views2, LookAtAClosedSolidFromOutsideWhereTheLightIs) {
  TestWorld world;
  world.add({0, 0, 0}, {1, 1, 1}, Facing::outward).add_sun({-0.5f, -1, -0.35f});
  for (const View& view : drawn(world, 4))
    EXPECT_GT(glm::distance(view.camera.position, glm::vec3(0.5f)), 0.9f) << "its corners are at 0.87";
}

TEST(Views2, LookAtTheFrontOfAnOpenQuad) {
  TestWorld world;
  world.add_quad({0, 0, 0}, {2, 0, 0}, {0, 2, 0}).add_sun({0.2f, -0.5f, -1});
  for (const View& view : drawn(world, 4)) EXPECT_GT(view.camera.position.z, 0.2f);
}

TEST(Views2, StandInTheMiddleOfANarrowCorridor) {
  TestWorld world;
  world.add({0, 0, 0}, {1, 2.5f, 20}, Facing::inward).add({0.2f, 0, 9}, {0.5f, 0.5f, 9.4f}, Facing::outward);
  world.add_light({0.5f, 2.3f, 4}).add_light({0.5f, 2.3f, 10}).add_light({0.5f, 2.3f, 16});
  for (const View& view : drawn(world, 5))
    EXPECT_NEAR(view.camera.position.x, 0.5f, 0.3f) << "0.2 from the walls";
}

TEST(Views2, OfAClosedBoxInTheDarkKeepClearAllTheSame) {
  TestWorld world;
  world.add({0, 0, 0}, {6, 3, 5}, Facing::inward).add_sun({-0.5f, -1, -0.35f});
  for (const View& view : drawn(world, 1))
    EXPECT_GE(distance_to_nearest_surface(world.scene(), view.camera.position), 0.2f);
}

TEST(Views2, AViewOfTheRoomIsValid) {
  EXPECT_EQ(why(lit_room(), {-2.5f, 1.6f, 2}, {1, 0.8f, -1}, 2), "valid");
}

TEST(Views2, ACameraJustAboveATableIsNotValid) {
  EXPECT_THAT(why(lit_room(), {-1.5f, 1.009f, -1}, {1, 1, 0}, 2),
              StartsWith("something is 0.009 from the camera, nearer than"));
}

TEST(Views2, ACameraInTheFaceOfAWallIsNotValid) {
  EXPECT_THAT(why(lit_room(), {0, 1.5f, 1.5f}, {0, 1.5f, 2.5f}, 2), HasSubstr("picture"));
}

TEST(Views2, ACameraInsideASolidIsNotValid) {
  EXPECT_THAT(why(lit_room(), {1.5f, 1, 1}, {0, 1, 0}, 2), StartsWith("the camera is inside something"));
}

TEST(Views2, ALightThatDoesNotComeInLeavesTheRoomBlack) {
  EXPECT_EQ(why(furnished_room().add_sun({0, -1, 0.1f}), {-2.5f, 1.6f, 2}, {1, 0.8f, -1}, 2),
            "light reaches only 0 % of what is in sight");
}

TEST(Views2, WithoutAnyLightAtAllLightIsNotAskedFor) {
  EXPECT_EQ(why(furnished_room(), {-2.5f, 1.6f, 2}, {1, 0.8f, -1}, 2), "valid");
}

TEST(Views2, AreDrawnWhereTheLightIs) {
  TestWorld world;  // two rooms side by side, one of them dark
  world.add({0, 0, 0}, {4, 3, 4}, Facing::inward).add({4.2f, 0, 0}, {8.2f, 3, 4}, Facing::inward);
  world.add({1, 0, 1}, {2, 0.7f, 2}, Facing::outward).add({6, 0, 1}, {7, 0.7f, 2}, Facing::outward);
  world.add_light({2, 2.7f, 2});
  for (const View& view : drawn(world, 8)) EXPECT_LT(view.camera.position.x, 4);
}

views_2::SceneScale scale_of(const TestWorld& world) {
  return views_2::scene_scale(world.scene(), world.rays());
}

TEST(SceneScale, ARoomAsHighAsRoomsAreIsInMetres) {
  EXPECT_EQ(scale_of(furnished_room()).eye_height, 1.6);
  EXPECT_EQ(scale_of(furnished_room()).least_clearance, 0.2);
}

TEST(SceneScale, ARoomOfAnotherHeightIsNot) {
  TestWorld world;
  world.add({0, 0, 0}, {550, 550, 550}, Facing::inward);
  EXPECT_NEAR(scale_of(world).eye_height, 0.6 * 550, 0.5);  // distances are floats
  EXPECT_EQ(scale_of(world).least_clearance, 0);
}

TEST(SceneScale, OnlyASmallThingInTheOpenIsAnObject) {
  TestWorld thing;
  thing.add({0, 0, 0}, {1, 0.1f, 1}, Facing::outward)
      .add({0.4f, 0.1f, 0.4f}, {0.6f, 1, 0.6f}, Facing::outward);
  EXPECT_TRUE(scale_of(thing).is_object);
  EXPECT_FALSE(scale_of(furnished_room()).is_object);
  TestWorld field;
  field.add({-50, -1, -50}, {50, 0, 50}, Facing::outward).add({3, 0, 3}, {4, 2, 4}, Facing::outward);
  EXPECT_FALSE(scale_of(field).is_object);
}

}  // namespace
}  // namespace lightbench
