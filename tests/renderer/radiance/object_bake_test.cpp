#include "renderer/radiance/object_bake.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/renderer/render_scene.h"

namespace lightbench {
namespace {

using test::floor_scene;
using ::testing::HasSubstr;

/// Of the only object, 'quad'.
BakeSettings with_size(const std::string& pattern, const glm::ivec2& size) {
  BakeSettings settings;
  settings.sizes = {{pattern, size}};
  return settings;
}

std::string error_of(const std::function<void()>& attempt) {
  try {
    attempt();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ObjectBake, MoreThanAFileHoldsIsAnErrorBeforeItIsTraced) {
  const Scene scene = floor_scene();
  BakeSettings settings = with_size("quad", {257, 257});
  settings.trace.grid.thetas = kMaxThetas;
  settings.trace.grid.phis = kMaxPhis;
  EXPECT_THAT(error_of([&] { ObjectBaker(scene).bake(0, settings); }),
              HasSubstr("object 'quad' of floor: 257 x 257 texels of 65536 directions are more than a file"));
}

TEST(ObjectBake, GlossyObjectsHaveMoreDirections) {
  Scene scene = floor_scene();
  BakeSettings settings;  // 20 x 20 directions up to an exponent of 40
  const auto directions = [&](float specular, float exponent) {
    scene.materials[0].specular = specular;
    scene.materials[0].exponent = exponent;
    const DirectionGrid grid = object_grid(scene, 0, settings);
    EXPECT_EQ(expected_sizes(scene, settings)[0].directions, grid.layers());
    return glm::ivec2(grid.thetas, grid.phis);
  };
  EXPECT_EQ(directions(0.5f, 40), glm::ivec2(20, 20));
  EXPECT_EQ(directions(0.5f, 160), glm::ivec2(39, 40)) << "half the step";
  EXPECT_EQ(directions(0.5f, 1e9f), glm::ivec2(45, 45)) << "as many as OpenGL takes";
  EXPECT_EQ(directions(0, 1e9f), glm::ivec2(20, 20)) << "no highlights";
  settings.trace.grid.thetas = 60;
  EXPECT_EQ(directions(0.5f, 1e9f), glm::ivec2(60, 34)) << "never fewer than asked for";
  settings.trace.grid.phis = 100;
  EXPECT_EQ(directions(0.5f, 1e9f), glm::ivec2(60, 100)) << "asked for, though OpenGL does not take as many";
  settings.trace.grid.phis = 20;
  settings.gloss_exponent = 0;
  EXPECT_EQ(directions(0.5f, 1e9f), glm::ivec2(60, 20));
}

TEST(ObjectBake, SizesAreOfObjectsThatThereAre) {
  const Scene scene = floor_scene();
  EXPECT_EQ(error_of([&] { check_named_sizes(scene, with_size("q*", {4, 4})); }), "no error");
  EXPECT_THAT(error_of([&] {
                check_named_sizes(scene, with_size("quat", {4, 4}));
              }),
              HasSubstr("floor has no object 'quat' (did you mean 'quad'?)"));
}

TEST(ObjectBake, ASurfaceWithoutAreaHasNoTexels) {
  Scene scene = floor_scene();
  for (glm::vec3& position : scene.meshes[0].positions) position = glm::vec3(1);
  const ObjectBake baked = ObjectBaker(scene).bake(0, {});
  EXPECT_EQ(baked.texels, 0u);
  EXPECT_EQ(baked.stack.layer_size(), 1u) << "the smallest texture";
}

TEST(ObjectBake, AMeshWithoutTrianglesIsNoObject) {
  Scene scene = floor_scene();
  scene.meshes[0].triangles.clear();
  scene.meshes[0].parts.clear();
  EXPECT_TRUE(objects_to_bake(scene).empty());
  EXPECT_TRUE(expected_sizes(scene, {}).empty());
}

}  // namespace
}  // namespace lightbench
