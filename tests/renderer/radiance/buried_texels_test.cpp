#include "renderer/radiance/buried_texels.h"

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include "renderer/radiance/object_bake.h"
#include "scene/box_mesh.h"
#include "tests/renderer/room_scenes.h"

namespace lightbench {
namespace {

using namespace test;

/// A floor from -10 to 10 with a box from -3 to 3 that stands on it, or `gap` above it, under a lamp.
Scene box_on_floor(float gap) {
  Scene scene = floor_scene();
  scene.meshes.push_back(box_mesh("box", {{-3, gap, -3}, {3, 2 + gap, 3}}, 0));
  scene.entities.push_back({"box", int(scene.meshes.size()) - 1});
  Light light;
  light.position = {0, 30, 0};
  light.power = 0.5f;
  scene.lights = {light};
  return scene;
}

BakeSettings floor_settings() {
  BakeSettings settings;
  settings.sizes = {{"*", {20, 20}}};
  settings.trace.grid = {2, 1, LayerOrder::theta_major};
  return settings;
}

/// The floor's red in the direction of its normal, row by row.
std::vector<float> floor_texels(const Scene& scene) {
  const BakeSettings settings = floor_settings();
  const ObjectBake baked = ObjectBaker(scene).bake(0, settings);
  std::vector<float> texels;
  for (const SurfaceTexel& texel : object_atlas(scene, 0, settings).surface)
    texels.push_back(
        glm::unpackHalf1x16(baked.stack.texels[baked.stack.index(texel.place.x, texel.place.y, 0)][0]));
  return texels;
}

TEST(BuriedTexels, AreThoseUnderABox) {
  const Scene scene = box_on_floor(0);
  EXPECT_EQ(std::ranges::count(floor_texels(box_on_floor(1)), 0.0f), 36);  // in its shadow, and seen
  for (const float texel : floor_texels(scene)) EXPECT_GT(texel, 0);
}

TEST(BuriedTexels, AreNotTraced) {
  EXPECT_EQ(ObjectBaker(box_on_floor(1)).bake(0, floor_settings()).texels, 400u);
  EXPECT_EQ(ObjectBaker(box_on_floor(0)).bake(0, floor_settings()).texels, 364u);
}

TEST(BuriedTexels, AGapBelowATwentiethOfATexelIsNone) {
  EXPECT_EQ(std::ranges::count(floor_texels(box_on_floor(0.01f)), 0.0f), 0);
  EXPECT_EQ(std::ranges::count(floor_texels(box_on_floor(0.2f)), 0.0f), 36);
}

TEST(BuriedTexels, TakeTheMeanOfWhatIsAroundThemFromTheEdgeInwards) {
  ChartAtlas atlas;
  atlas.width = 5, atlas.height = 1;
  HalfStack stack{5, 1, {2, 1, LayerOrder::theta_major}, 1, {}};
  for (int x = 0; x < 5; ++x) atlas.surface.push_back({{x, 0}, 0, 0, 0});
  for (const float value : {1.0f, 0.0f, 0.0f, 0.0f, 3.0f, 5.0f, 0.0f, 0.0f, 0.0f, 7.0f})
    stack.texels.push_back({glm::packHalf1x16(value), 0, 0});
  fill_buried(atlas, {false, true, true, true, false}, stack);
  std::vector<float> values;
  for (const auto& texel : stack.texels) values.push_back(glm::unpackHalf1x16(texel[0]));
  EXPECT_EQ(values, (std::vector<float>{1, 1, 2, 3, 3, 5, 5, 6, 7, 7}));
}

TEST(BuriedTexels, ChartsBuriedWholeStayAsTheyAre) {
  ChartAtlas atlas;
  atlas.width = 2, atlas.height = 1;
  HalfStack stack{2, 1, {2, 1, LayerOrder::theta_major}, 1, {}};
  stack.texels.resize(4);
  atlas.surface = {{{0, 0}, 0, 0, 0}, {{1, 0}, 0, 0, 0}};
  fill_buried(atlas, {true, true}, stack);
  for (const auto& texel : stack.texels) EXPECT_EQ(texel, (std::array<std::uint16_t, 3>{}));
}

}  // namespace
}  // namespace lightbench
