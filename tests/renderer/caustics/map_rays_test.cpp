#include "renderer/caustics/map_rays.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/water.h"
#include "tests/renderer/caustics/water_scenes.h"

namespace lightbench {
namespace {

using namespace test;

TEST(MapRays, FollowTheRefractedRays) {
  Scene scene = pool_scene({1, -3, 0.5f});
  scene.water->waves = {{0.05f, 1.5f, {0.6f, 0.8f}, 0, 0}};
  const Light& light = scene.lights[0];
  const ReceiverBox box = receiver_box(scene, 0, light);
  const Mesh mesh = water_mesh(*scene.water, 0);
  const WaterLight through = water_light(*scene.water, mesh, light, false);
  const MapRays rays = map_rays(mesh, through, box);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double z = 0.3;
    const double way = double(rays.ways[i].x) + z * double(rays.ways[i].y);
    const glm::dvec3 place =
        box.to_map(glm::dvec3(mesh.positions[i]) + way * glm::dvec3(through.directions[i]));
    EXPECT_NEAR(place.z, z, 1e-5);
    EXPECT_NEAR(place.x, double(rays.places[i].x) + z * double(rays.places[i].z), 1e-5);
    EXPECT_NEAR(place.y, double(rays.places[i].y) + z * double(rays.places[i].w), 1e-5);
  }
}

TEST(MapRays, AreasAreThoseOfTheImages) {
  Scene scene = pool_scene({1, -3, 0.5f});
  scene.water->waves = {{0.1f, 1.0f, {0.6f, 0.8f}, 0, 0}};
  const ReceiverBox box = receiver_box(scene, 0, scene.lights[0]);
  const Mesh mesh = water_mesh(*scene.water, 0);
  const MapRays rays = map_rays(mesh, water_light(*scene.water, mesh, scene.lights[0], false), box);
  ASSERT_EQ(rays.corners.size(), rays.triangles.size());
  ASSERT_GT(rays.corners.size(), 0U);
  for (std::size_t i = 0; i < rays.corners.size(); ++i) {
    const double z = 0.7;
    const auto place = [&](std::uint32_t vertex) {
      const glm::dvec4 p(rays.places[vertex]);
      return glm::dvec2(p.x + z * p.z, p.y + z * p.w) * glm::dvec2(box.size.x, box.size.z);
    };
    const glm::dvec2 a = place(rays.corners[i].y) - place(rays.corners[i].x),
                     b = place(rays.corners[i].z) - place(rays.corners[i].x);
    const glm::dvec3 area(rays.triangles[i].area);
    EXPECT_NEAR(area.x + z * (area.y + z * area.z), 0.5 * (a.x * b.y - a.y * b.x), 1e-5);
  }
}

TEST(MapRays, VolumesThatMissTheBoxAreCulled) {
  Scene scene = pool_scene({0, -1, 0});
  add_box(scene, "stone", {{0.1f, 0, 0.1f}, {0.4f, 0.5f, 0.4f}});
  const ReceiverBox box = receiver_box(scene, 1, scene.lights[0]);
  const Mesh mesh = water_mesh(*scene.water, 0);
  const WaterLight through = water_light(*scene.water, mesh, scene.lights[0], false);
  EXPECT_EQ(map_rays(mesh, through, box, VolumeCulling::off).corners.size(), 128U);
  // The stone lies below one of the 64 squares of half a unit.
  const MapRays culled = map_rays(mesh, through, box);
  EXPECT_EQ(culled.corners.size(), 2U);
  EXPECT_EQ(culled.lit, 128U);
}

}  // namespace
}  // namespace lightbench
