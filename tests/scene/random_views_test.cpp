#include "scene/random_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/camera_script.h"
#include "view_world.h"

namespace lightbench {
namespace {

using namespace test;
using ::testing::HasSubstr;

/// What every version of the generator promises.
class RandomViews : public ::testing::TestWithParam<int> {
 protected:
  static std::vector<View> drawn(const TestWorld& world, int count, std::uint64_t seed) {
    return draw_random_views(world.scene(), draw(count, seed, GetParam()), world.rays());
  }
};
INSTANTIATE_TEST_SUITE_P(Versions, RandomViews, ::testing::Range(1, kNewestGenerator + 1));

TEST_P(RandomViews, AreTheSameForTheSameSeed) {
  const TestWorld world = furnished_room();
  EXPECT_EQ(camera_script_text(drawn(world, 5, 7)), camera_script_text(drawn(world, 5, 7)));
}

TEST_P(RandomViews, DifferForAnotherSeed) {
  const TestWorld world = furnished_room();
  EXPECT_NE(drawn(world, 1, 7)[0].camera.position, drawn(world, 1, 8)[0].camera.position);
}

TEST_P(RandomViews, BeginAlikeHoweverManyAreDrawn) {
  const TestWorld world = furnished_room();
  EXPECT_EQ(drawn(world, 2, 7)[1].camera.position, drawn(world, 6, 7)[1].camera.position);
}

TEST_P(RandomViews, AreNamedAfterTheirSeed) {
  const auto views = drawn(furnished_room(), 2, 42);
  EXPECT_EQ(views[0].name, "random-42-0001");
  EXPECT_EQ(views[1].name, "random-42-0002");
}

TEST_P(RandomViews, AreAllValid) {
  const TestWorld world = furnished_room();
  for (const View& view : drawn(world, 6, 3))
    EXPECT_EQ(why_view_is_invalid(world.scene(), view, kAspect, world.rays(), GetParam()), std::nullopt)
        << view.name;
}

TEST_P(RandomViews, StandInsideTheRoomAndOutsideTheFurniture) {
  const TestWorld world = furnished_room();
  for (const View& view : drawn(world, 10, 4)) {
    const glm::vec3 p = view.camera.position;
    EXPECT_TRUE(p.x > -3 && p.x < 3 && p.y > 0 && p.y < 3 && p.z > -2.5f && p.z < 2.5f);
    EXPECT_FALSE(p.x > 1 && p.x < 2 && p.y < 2 && p.z > 0.5f && p.z < 1.5f);
  }
}

TEST_P(RandomViews, AreFoundWhereAllWallsAreTurnedInsideOut) {
  EXPECT_EQ(drawn(furnished_room(Facing::outward, Facing::inward), 3, 1).size(), 3u);
}

TEST_P(RandomViews, AreFoundAtAnyScale) {
  for (const float scale : {1e-3f, 1e4f}) {
    TestWorld world;
    world.add(scale * glm::vec3(-3, 0, -2), scale * glm::vec3(3, 3, 2), Facing::inward)
        .add(scale * glm::vec3(0, 0, 0), scale * glm::vec3(1, 1, 1), Facing::outward);
    EXPECT_EQ(drawn(world, 3, 1).size(), 3u) << scale;
  }
}

TEST_P(RandomViews, OfASceneWithoutAnyAreAnErrorThatSaysWhy) {
  TestWorld world;
  world.add({0, 0, 0}, {1, 1, 1}, Facing::outward);
  const ClosestHit nothing = [](const glm::vec3&, const glm::vec3&) { return std::optional<RayHit>(); };
  try {
    draw_random_views(world.scene(), draw(1, 1, GetParam()), nothing);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("like this: 100 % of the picture are background"));
  }
}

TEST_P(RandomViews, OfAnEmptySceneAreAnError) {
  EXPECT_THROW(drawn(TestWorld(), 1, 1), Error);
}

TEST(RandomViewsVersion, ThatIsNotThereIsAnError) {
  const TestWorld world = furnished_room();
  for (const int version : {0, kNewestGenerator + 1})
    EXPECT_THROW(draw_random_views(world.scene(), draw(1, 1, version), world.rays()), Error);
}

TEST(RandomViewsVersion, IsTheNewestUnlessItIsNamed) {
  EXPECT_EQ(RandomViewOptions().version, kNewestGenerator);
}

}  // namespace
}  // namespace lightbench
