#include "scene/random_views.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/box_mesh.h"
#include "scene/camera_script.h"
#include "scene/view_judge.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr float kAspect = 4.0f / 3.0f;

enum class Facing { outward, inward };

class TestWorld {
 public:
  TestWorld& add(const glm::vec3& min, const glm::vec3& max, Facing facing) {
    Bounds box;
    box.add(min);
    box.add(max);
    Mesh mesh = box_mesh("box", box, 0);
    if (facing == Facing::inward)
      for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    scene_.meshes.push_back(std::move(mesh));
    scene_.entities.push_back({"box", int(scene_.meshes.size()) - 1, glm::mat4(1)});
    return *this;
  }

  const Scene& scene() const { return scene_; }
  ClosestHit rays() const {
    return [this](const glm::vec3& origin, const glm::vec3& direction) { return trace(origin, direction); };
  }

 private:
  std::optional<RayHit> trace(const glm::vec3& origin, const glm::vec3& direction) const {
    std::optional<RayHit> closest;
    for (const Mesh& mesh : scene_.meshes)
      for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 a = mesh.positions[t.x];
        const glm::vec3 ab = mesh.positions[t.y] - a;
        const glm::vec3 ac = mesh.positions[t.z] - a;
        const glm::vec3 p = glm::cross(direction, ac);
        const float det = glm::dot(ab, p);
        if (std::abs(det) < 1e-12f) continue;
        const float u = glm::dot(origin - a, p) / det;
        const glm::vec3 q = glm::cross(origin - a, ab);
        const float v = glm::dot(direction, q) / det;
        const float distance = glm::dot(ac, q) / det;
        if (u < 0 || v < 0 || u + v > 1 || distance <= 0) continue;
        if (!closest || distance < closest->distance)
          closest = RayHit{distance, glm::normalize(glm::cross(ab, ac))};
      }
    return closest;
  }

  Scene scene_;
};

// A room of 6 x 3 x 5 with three solid boxes in it.
TestWorld furnished_room(Facing room = Facing::inward, Facing furniture = Facing::outward) {
  TestWorld world;
  world.add({-3, 0, -2.5f}, {3, 3, 2.5f}, room)
      .add({-2, 0, -2}, {-1, 1, 0}, furniture)
      .add({1, 0, 0.5f}, {2, 2, 1.5f}, furniture)
      .add({0.5f, 0, -2}, {2.5f, 0.8f, -1}, furniture);
  return world;
}

RandomViewOptions draw(int count, std::uint64_t seed) {
  RandomViewOptions options;
  options.count = count;
  options.seed = seed;
  return options;
}

std::string why(const TestWorld& world, const glm::vec3& position, const glm::vec3& look_at) {
  View view{"v", {}};
  view.camera.position = position;
  view.camera.look_at = look_at;
  return why_view_is_invalid(world.scene(), view, kAspect, world.rays()).value_or("valid");
}

TEST(RandomViews, AreTheSameForTheSameSeed) {
  const TestWorld world = furnished_room();
  const auto a = draw_random_views(world.scene(), draw(5, 7), world.rays());
  const auto b = draw_random_views(world.scene(), draw(5, 7), world.rays());
  EXPECT_EQ(camera_script_text(a), camera_script_text(b));
}

TEST(RandomViews, AreTheSameOnEveryPlatform) {
  const TestWorld world = furnished_room();
  const auto views = draw_random_views(world.scene(), draw(1, 7), world.rays());
  EXPECT_EQ(views[0].camera.position, glm::vec3(-0.6884f, 0.8429f, -1.5844f));
  EXPECT_EQ(views[0].camera.look_at, glm::vec3(-0.0262f, 0.6924f, -1.0957f));
}

TEST(RandomViews, DifferForAnotherSeed) {
  const TestWorld world = furnished_room();
  EXPECT_NE(draw_random_views(world.scene(), draw(1, 7), world.rays())[0].camera.position,
            draw_random_views(world.scene(), draw(1, 8), world.rays())[0].camera.position);
}

TEST(RandomViews, BeginAlikeHoweverManyAreDrawn) {
  const TestWorld world = furnished_room();
  const auto few = draw_random_views(world.scene(), draw(2, 7), world.rays());
  const auto many = draw_random_views(world.scene(), draw(6, 7), world.rays());
  EXPECT_EQ(few[1].camera.position, many[1].camera.position);
}

TEST(RandomViews, AreNamedAfterTheirSeed) {
  const TestWorld world = furnished_room();
  const auto views = draw_random_views(world.scene(), draw(2, 42), world.rays());
  EXPECT_EQ(views[0].name, "random-42-0001");
  EXPECT_EQ(views[1].name, "random-42-0002");
}

TEST(RandomViews, AreAllValid) {
  const TestWorld world = furnished_room();
  for (const View& view : draw_random_views(world.scene(), draw(20, 3), world.rays()))
    EXPECT_EQ(why_view_is_invalid(world.scene(), view, kAspect, world.rays()), std::nullopt) << view.name;
}

TEST(RandomViews, StandInsideTheRoomAndOutsideTheFurniture) {
  const TestWorld world = furnished_room();
  for (const View& view : draw_random_views(world.scene(), draw(20, 4), world.rays())) {
    const glm::vec3 p = view.camera.position;
    EXPECT_TRUE(p.x > -3 && p.x < 3 && p.y > 0 && p.y < 3 && p.z > -2.5f && p.z < 2.5f);
    EXPECT_FALSE(p.x > 1 && p.x < 2 && p.y < 2 && p.z > 0.5f && p.z < 1.5f);
  }
}

TEST(RandomViews, AreFoundWhereAllWallsAreTurnedInsideOut) {
  const TestWorld world = furnished_room(Facing::outward, Facing::inward);
  EXPECT_EQ(draw_random_views(world.scene(), draw(3, 1), world.rays()).size(), 3u);
}

TEST(RandomViews, AreFoundAtAnyScale) {
  for (const float scale : {1e-3f, 1e4f}) {
    TestWorld world;
    world.add(scale * glm::vec3(-3, 0, -2), scale * glm::vec3(3, 3, 2), Facing::inward)
        .add(scale * glm::vec3(0, 0, 0), scale * glm::vec3(1, 1, 1), Facing::outward);
    EXPECT_EQ(draw_random_views(world.scene(), draw(3, 1), world.rays()).size(), 3u) << scale;
  }
}

TEST(RandomViews, OfASceneWithoutAnyAreAnErrorThatSaysWhy) {
  TestWorld world;
  world.add({0, 0, 0}, {1, 1, 1}, Facing::outward);
  const ClosestHit nothing = [](const glm::vec3&, const glm::vec3&) { return std::optional<RayHit>(); };
  try {
    draw_random_views(world.scene(), draw(1, 1), nothing);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("100 % of the picture are background"));
  }
}

TEST(RandomViews, OfAnEmptySceneAreAnError) {
  const TestWorld world;
  EXPECT_THROW(draw_random_views(world.scene(), draw(1, 1), world.rays()), Error);
}

TEST(ViewValidity, AViewOfTheRoomIsValid) {
  EXPECT_EQ(why(furnished_room(), {-2.5f, 1.6f, 2}, {1, 0.8f, -1}), "valid");
}

TEST(ViewValidity, ACameraInsideASolidIsNotValid) {
  EXPECT_THAT(why(furnished_room(), {1.5f, 1, 1}, {0, 1, 0}), StartsWith("the camera is inside something"));
}

TEST(ViewValidity, ACameraBehindTheWallsIsNotValid) {
  TestWorld world = furnished_room();
  world.add({-20, -1, -20}, {20, -0.5f, 20}, Facing::outward);
  EXPECT_THAT(why(world, {0, 1.5f, 6}, {0, 1.5f, 0}), HasSubstr("back faces"));
}

TEST(ViewValidity, ACameraThatTouchesAWallIsNotValid) {
  EXPECT_THAT(why(furnished_room(), {2.995f, 1.5f, 0}, {0, 1, 0}), HasSubstr("from the camera, nearer than"));
}

TEST(ViewValidity, AViewOfTheSkyIsNotValid) {
  TestWorld world;
  world.add({-50, -1, -50}, {50, 0, 50}, Facing::outward).add({3, 0, 3}, {4, 2, 4}, Facing::outward);
  EXPECT_THAT(why(world, {0, 2, 0}, {5, 7, 0}), HasSubstr("are background"));
}

TEST(ViewValidity, AWallThatFillsThePictureIsNotValid) {
  EXPECT_THAT(why(furnished_room(), {0, 1.5f, 1.5f}, {0, 1.5f, 2.5f}), HasSubstr("a single flat surface"));
}

TEST(ViewValidity, AViewOfSomethingFarAwayOnlyIsNotValid) {
  TestWorld world;
  world.add({0, 0, 0}, {1, 1, 1}, Facing::outward).add({100, 0, 0}, {101, 1, 1}, Facing::outward);
  View view{"v", {}};
  view.camera.position = {-150, 120, -150};
  view.camera.look_at = {0.5f, 0.5f, 0.5f};
  view.camera.fov = 0.004f;
  EXPECT_EQ(why_view_is_invalid(world.scene(), view, kAspect, world.rays()),
            "nothing is near enough in sight");
}

}  // namespace
}  // namespace lightbench
