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
  EXPECT_TRUE(expected_texels(scene, {}).empty());
}

}  // namespace
}  // namespace lightbench
