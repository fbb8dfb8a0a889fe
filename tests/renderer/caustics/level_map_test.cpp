#include "renderer/caustics/level_map.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/caustics/flux_compare.h"
#include "renderer/caustics/light_tracer.h"
#include "renderer/caustics/volumetric.h"
#include "scene/water.h"
#include "tests/renderer/caustics/gl_frame.h"
#include "tests/renderer/caustics/water_scenes.h"

namespace lightbench {
namespace {

using namespace test;

/// Of the first light on an entity.
Image level_map(const Scene& scene, std::size_t entity, const LevelMapOptions& options = {},
                const DrawnOptions& how = {}) {
  GlFrame frame(scene);
  const DrawnReceiver drawn(frame.context(), entity, how);
  return read_back(draw_level_map(frame.context(), drawn.map, drawn.volumes, options), 4);
}

TEST(GlLevelMap, FlatWaterBrightensByTheCosines) {
  Scene scene = pool_scene({3, -4, 0});
  add_box(scene, "stone", {{-0.5f, 0, -0.5f}, {0.5f, 0.01f, 0.5f}});
  scene.water->absorption = {0, 0.1f, 0.5f};
  const Image map = level_map(scene, 1);
  const double sine = 0.6 / double(scene.water->ior), cosine = std::sqrt(1 - sine * sine);
  const double way = 1.99 / cosine;
  const auto middle = map.pixel(64, 64);
  // A hundred slices of a box as high as the stone is wide times the light's sine: half of one off at most.
  const double off = 0.5 * sine / 100;
  EXPECT_NEAR(double(middle[0]), 0.8 / cosine, 1e-4);
  EXPECT_NEAR(double(middle[1]), 0.8 / cosine * std::exp(-0.1 * way), 0.1 * off);
  EXPECT_NEAR(double(middle[2]), 0.8 / cosine * std::exp(-0.5 * way), 0.5 * off);
  EXPECT_EQ(middle[3], 0) << "nothing folds";
}

TEST(GlLevelMap, APointLightsAsItsDistance) {
  Scene scene = pool_scene({0, -1, 0});
  scene.lights = {point_light({0, 6, 0})};
  scene.lights[0].attenuation = {Attenuation::Kind::inverse_square};
  scene.water->grid = {71, 71};
  add_box(scene, "stone", {{-0.1f, 0, -0.1f}, {0.1f, 0.01f, 0.1f}});
  const Image map = level_map(scene, 1);
  // Straight down, as from an apparent distance of 4 + 1.99 / ior.
  const double distance = 4 + 1.99 / double(scene.water->ior);
  EXPECT_NEAR(double(map.pixel(64, 64)[0]), 1 / (distance * distance), 2e-4);
}

TEST(GlLevelMap, ASineWaveFocusesAtTheAnalyticDepth) {
  Scene scene = pool_scene({0, -1, 0});
  const double amplitude = 0.02, wave_number = 2 * 3.14159265358979 / 0.8;
  // A crest is a lens of this focal length: it bends rays by (1 - 1 / ior) times its slope.
  const double focus = 1 / ((1 - 1 / double(scene.water->ior)) * amplitude * wave_number * wave_number);
  scene.water->grid = {561, 5};
  scene.water->waves = {{float(amplitude), 0.8f, {1, 0}, 0, 1.5707963f}};  // a crest at x = 0
  add_box(scene, "stone", {{-0.5f, 0, -0.5f}, {0.5f, 0.01f, 0.5f}});
  for (const double share : {0.25, 0.5, 0.75}) {
    const double depth = share * focus;  // below the crest
    scene.water->height = float(depth - amplitude + 0.01);
    const Image map = level_map(scene, 1, {}, {.size = 256});
    EXPECT_NEAR(double(map.pixel(128, 128)[0]), 1 / (1 - share), 0.02 / (1 - share)) << share;
    // Under a trough, at x = 0.4 and -0.4, whichever way the map lies.
    const float trough = std::min({map.pixel(230, 128)[0], map.pixel(26, 128)[0], map.pixel(128, 230)[0]});
    EXPECT_NEAR(double(trough), 1 / (1 + (depth - 2 * amplitude) / focus), 0.01) << share;
  }
}

TEST(GlCausticsTechnique, TwoLightsAdd) {
  Scene scene = sphere_in_waves();
  const Light first = scene.lights[0];
  Light second = directional_light({-0.5f, -1, 0.2f});
  second.name = "moon";
  second.color = {0.2f, 0.4f, 0.8f};
  const auto picture = [&](const std::vector<Light>& lights) {
    scene.lights = lights;
    RenderSetup setup;
    setup.technique = "caustics";
    setup.params = {{"map_size", 64LL}, {"surface", false}};
    return render(scene, top_view(6), setup).image;
  };
  const Image both = picture({first, second}), one = picture({first}), other = picture({second});
  float most = 0;
  for (std::size_t i = 0; i < both.data.size(); ++i) {
    if (i % 4 == 3) continue;
    // Of what half floats keep.
    ASSERT_NEAR(both.data[i], one.data[i] + other.data[i], 2e-3f * (1 + both.data[i])) << i;
    most = std::max(most, other.data[i]);
  }
  EXPECT_GT(most, 0.2f);
}

TEST(GlLevelMap, AllWaysGiveTheSameBits) {
  const Scene scene = sphere_in_waves();
  LevelMapOptions plain;
  plain.test = PlaneTest::discard;
  plain.slicing = Slicing::uniform;
  for (const bool occluders : {false, true}) {
    const Image expected =
        level_map(scene, 1, plain, {.culling = VolumeCulling::off, .occluders = occluders});
    EXPECT_GT(*std::max_element(expected.data.begin(), expected.data.end()), 1);
    for (const PlaneTest test : {PlaneTest::equal, PlaneTest::discard})
      for (const Slicing slicing :
           {Slicing::local, Slicing::smart, Slicing::smart_read_back, Slicing::uniform}) {
        LevelMapOptions options;
        options.test = test;
        options.slicing = slicing;
        EXPECT_EQ(level_map(scene, 1, options, {.occluders = occluders}), expected)
            << int(test) << " " << int(slicing) << " " << occluders;
      }
  }
}

TEST(GlLevelMap, AllWaysGiveTheSameBitsOnMapsOfAnySize) {
  Scene scene = sphere_in_waves();
  scene.water->grid = {9, 9};  // triangles that cover many blocks of texels
  LevelMapOptions plain;
  plain.slicing = Slicing::uniform;
  plain.slices = 20;
  LevelMapOptions local = plain;
  local.slicing = Slicing::local;
  for (const int size : {16, 100, 2056})
    EXPECT_EQ(differing_texels(level_map(scene, 1, local, {.size = size}),
                               level_map(scene, 1, plain, {.size = size})),
              0U)
        << size;
}

TEST(GlLevelMap, ATriangleThatCoversAllOfALargeMapLightsAllOfIt) {
  Scene scene = pool_scene({0, -1, 0});
  // Steps within one of the water's triangles: the planes between them touch no texel, in any of its blocks.
  add_box(scene, "steps", {{0.1f, 0, 0.3f}, {0.13f, 0.03f, 0.33f}});
  add_box(scene, "steps", {{0.13f, 0, 0.3f}, {0.16f, 1, 0.33f}});
  Mesh joined = scene.meshes[1];
  const auto first = std::uint32_t(joined.positions.size());
  const Mesh& other = scene.meshes[2];
  joined.positions.insert(joined.positions.end(), other.positions.begin(), other.positions.end());
  joined.normals.insert(joined.normals.end(), other.normals.begin(), other.normals.end());
  joined.uvs.clear();
  for (const glm::uvec3& t : other.triangles) joined.triangles.push_back(t + first);
  joined.parts = {{0, 0, std::uint32_t(joined.triangles.size())}};
  scene.meshes = {scene.meshes[0], joined};
  scene.entities.pop_back();
  const Image map = level_map(scene, 1, {}, {.size = 512});
  for (int y = 8; y < 504; y += 16)
    for (int x = 8; x < 504; x += 16) ASSERT_NEAR(map.pixel(x, y)[0], 1, 1e-3f) << x << " " << y;
}

/// Something that reaches out of the water, and something over it.
Scene shaded_sphere() {
  Scene scene = sphere_in_waves();
  add_box(scene, "post", {{-1.5f, 0, -0.2f}, {-1.3f, 4, 0.2f}});
  add_box(scene, "board", {{-1.5f, 3.9f, -0.3f}, {0.2f, 4, 0.3f}});
  return scene;
}

FluxLikeness to_rays(const Scene& scene, std::size_t entity) {
  LightTraceOptions options;
  options.rays = 4'000'000;
  options.map_size = 256;
  const FluxField traced = flux_field(trace_light(scene, scene.lights[0], options).maps[entity]);
  return compare_flux(flux_field(level_map(scene, entity, {}, {.size = 256})), traced, 8);
}

TEST(GlLevelMap, WhatStandsAboveTheWaterShadesIt) {
  Light lamp = point_light({-1, 8, 0.5f});
  lamp.power = 50;
  lamp.attenuation = {Attenuation::Kind::inverse_square};
  for (const Light& light : {directional_light({0.4f, -2, 0.3f}), lamp}) {
    Scene shaded = shaded_sphere(), open = sphere_in_waves();
    shaded.lights = open.lights = {light};
    for (const std::size_t entity : {0U, 1U}) {
      // As near to rays as without the shade.
      const FluxLikeness with = to_rays(shaded, entity), without = to_rays(open, entity);
      EXPECT_GT(with.correlation, without.correlation.value() - 0.01) << light.name << entity;
      EXPECT_NEAR(with.energy.value(), without.energy.value(), 0.03) << light.name << entity;
    }
    const FluxField dark = flux_field(level_map(shaded, 1)), bright = flux_field(level_map(open, 1));
    EXPECT_LT(compare_flux(dark, bright, 8).energy.value(), 0.9) << light.name;
  }
}

TEST(GlLevelMap, AllWaysGiveTheSameBitsInShade) {
  const Scene scene = shaded_sphere();
  const Image expected = level_map(scene, 1);
  for (const Slicing slicing : {Slicing::smart, Slicing::uniform}) {
    LevelMapOptions options;
    options.slicing = slicing;
    EXPECT_EQ(level_map(scene, 1, options), expected) << int(slicing);
  }
}

TEST(GlVolumetric, GivesTheBitsOfTheLevelMap) {
  Scene scene = shaded_sphere();
  add_box(scene, "lid", {{-0.5f, 2.2f, -0.5f}, {0, 2.3f, 0.5f}});
  for (const bool occluders : {false, true}) {
    const Image expected = level_map(scene, 1, {}, {.occluders = occluders});
    for (const SliceDrawing drawing : {SliceDrawing::whole, SliceDrawing::clusters}) {
      GlFrame frame(scene);
      const DrawnReceiver drawn(frame.context(), 1, {.occluders = occluders});
      const Image map =
          read_back(draw_volumetric(frame.context(), drawn.map, drawn.volumes, {100, drawing}), 4);
      EXPECT_EQ(differing_texels(map, expected), 0U) << int(drawing) << " " << occluders;
    }
  }
}

TEST(GlLevelMap, ShowsWhatTheLightTracerShows) {
  const Scene scene = sphere_in_waves();
  LightTraceOptions options;
  options.rays = 4'000'000;
  options.map_size = 512;
  const LightTrace trace = trace_light(scene, scene.lights[0], options);
  for (const std::size_t entity : {0U, 1U}) {
    const FluxField traced = flux_field(trace.maps[entity]);
    const FluxField drawn = flux_field(level_map(scene, entity, {}, {.size = 512}));
    const FluxLikeness likeness = compare_flux(drawn, traced, 8);
    // On the ball, 4 million rays are 15 to a texel: a quarter of noise before the mean over 3 x 3. On the
    // floor light folds: where a triangle's image has next to no area, single texels take much of its light.
    EXPECT_GT(likeness.correlation, entity == 0 ? 0.97 : 0.99) << entity;
    EXPECT_NEAR(likeness.energy.value(), 1, entity == 0 ? 0.01 : 0.002) << entity;
  }
}

/// Of what enters the water of a tank without a gap, the share that lands on its floor and walls.
double landed_share(const Scene& scene) {
  double landed = 0, entered = 0;
  for (std::size_t entity = 0; entity < scene.entities.size(); ++entity) {
    const ReceiverBox box = receiver_box(scene, entity, scene.lights[0]);
    const FluxField field = flux_field(level_map(scene, entity, {}, {.size = 512}));
    for (const double flux : field.values)
      landed += flux * box.size.x * box.size.z / double(field.values.size());
  }
  for (const glm::vec3& flux :
       water_light(*scene.water, water_mesh(*scene.water, 0), scene.lights[0], false).flux)
    entered += double(flux.r);
  return landed / entered;
}

TEST(GlLevelMap, AClosedTankKeepsAllLight) {
  Scene scene = pool_scene({0.5f, -1, 0.3f});
  scene.water->grid = {71, 71};
  for (const float side : {-1.0f, 1.0f}) {
    const float near = side * 2, far = side * 2.2f;
    add_box(scene, "wall", {{std::min(near, far), 0, -2.2f}, {std::max(near, far), 2, 2.2f}});
    add_box(scene, "wall", {{-2, 0, std::min(near, far)}, {2, 2, std::max(near, far)}});
  }
  EXPECT_NEAR(landed_share(scene), 1, 0.01);
  scene.water->waves = {{0.03f, 1.1f, {0.6f, 0.8f}, 0, 0}, {0.02f, 0.8f, {-0.8f, 0.6f}, 0, 1}};
  // What waves bend onto places that the maps do not show is missing, and none is lit twice.
  const double share = landed_share(scene);
  EXPECT_GT(share, 0.98);
  EXPECT_LT(share, 1);
}

TEST(GlLevelMap, WhatStandsAboveShadesWhatIsBelow) {
  Scene scene = pool_scene({0, -1, 0});
  add_box(scene, "stone", {{-0.5f, 0, -0.5f}, {0.5f, 0.1f, 0.5f}});
  add_box(scene, "lid", {{-0.5f, 1, -0.5f}, {0, 1.1f, 0.5f}});
  const Image map = level_map(scene, 1);
  // u runs along x or against it: one half is dark.
  const float left = map.pixel(32, 64)[0], right = map.pixel(96, 64)[0], top = map.pixel(64, 32)[0],
              bottom = map.pixel(64, 96)[0];
  EXPECT_EQ(std::min({left, right, top, bottom}), 0);
  EXPECT_NEAR(std::max({left, right, top, bottom}), 1, 1e-4);
}

TEST(GlLevelMap, NothingIsLitAboveTheWater) {
  Scene scene = pool_scene({0, -1, 0});
  add_box(scene, "pillar", {{-0.5f, 2.1f, -0.5f}, {0.5f, 3, 0.5f}});
  const Image map = level_map(scene, 1);
  EXPECT_EQ(*std::max_element(map.data.begin(), map.data.end()), 0);
}

}  // namespace
}  // namespace lightbench
