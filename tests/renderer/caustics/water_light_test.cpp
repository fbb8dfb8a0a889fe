#include "renderer/caustics/water_light.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scene/water.h"
#include "tests/renderer/caustics/water_scenes.h"

namespace lightbench {
namespace {

using namespace test;

glm::dvec3 whole_flux(const WaterLight& light) {
  glm::dvec3 sum(0);
  for (const glm::vec3& flux : light.flux) sum += glm::dvec3(flux);
  return sum;
}

TEST(WaterLight, OfFlatWaterIsAsMuchAsFallsOnIt) {
  const Scene scene = pool_scene({3, -4, 0});
  const Mesh mesh = water_mesh(*scene.water, 0);
  const WaterLight light = water_light(*scene.water, mesh, scene.lights[0], false);
  EXPECT_NEAR(whole_flux(light).r, 16 * 0.8, 1e-4);
  const double sine = 0.6 / double(scene.water->ior);
  for (const glm::vec3& direction : light.directions) {
    EXPECT_NEAR(direction.x, sine, 1e-6);
    EXPECT_NEAR(direction.y, -std::sqrt(1 - sine * sine), 1e-6);
  }
}

TEST(WaterLight, OfWavesIsAsMuchAsFallsOnTheirRectangle) {
  // From straight above all triangles together are as wide as the rectangle.
  Scene scene = pool_scene({0, -1, 0});
  scene.water->waves = {{0.1f, 1.5f, {0.6f, 0.8f}, 0, 0}};
  const Mesh mesh = water_mesh(*scene.water, 0);
  EXPECT_NEAR(whole_flux(water_light(*scene.water, mesh, scene.lights[0], false)).g, 16, 1e-4);
}

TEST(WaterLight, FresnelTakesWhatIsReflected) {
  const Scene scene = pool_scene({3, -4, 0});
  const Mesh mesh = water_mesh(*scene.water, 0);
  const double all = whole_flux(water_light(*scene.water, mesh, scene.lights[0], false)).r;
  const double share = fresnel_transmission({0.6, -0.8, 0}, {0, 1, 0}, 1 / double(scene.water->ior));
  EXPECT_NEAR(whole_flux(water_light(*scene.water, mesh, scene.lights[0], true)).r, share * all, 1e-4);
  EXPECT_LT(share, 0.99);
}

TEST(WaterLight, OfAPointGoesAwayFromIt) {
  Scene scene = pool_scene({0, -1, 0});
  Light lamp = point_light({0, 5, 0});
  lamp.power = 2;
  lamp.color = {1, 0.5f, 0};
  const Mesh mesh = water_mesh(*scene.water, 0);
  const WaterLight light = water_light(*scene.water, mesh, lamp, false);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 away = mesh.positions[i] - lamp.position;
    const float sine = std::hypot(away.x, away.z) / glm::length(away);
    EXPECT_NEAR(std::hypot(light.directions[i].x, light.directions[i].z), sine / scene.water->ior, 1e-6);
    EXPECT_GE(light.directions[i].x * away.x + light.directions[i].z * away.z, 0);
  }
  const glm::dvec3 flux = whole_flux(light);
  EXPECT_NEAR(flux.g, flux.r / 2, 1e-5);
  EXPECT_EQ(flux.b, 0);
}

TEST(WaterLight, TellsWhatCannotShineThrough) {
  Scene scene = pool_scene({0, -1, 0});
  EXPECT_EQ(water_light_problem(scene, scene.lights[0]), "");
  EXPECT_EQ(water_light_problem(scene, directional_light({1, 0.1f, 0})),
            "light 'sun' does not shine down on the water");
  Light lamp = point_light({0, 2.05f, 0});
  EXPECT_EQ(water_light_problem(scene, lamp), "");
  scene.water->waves = {{0.1f, 1, {1, 0}, 0, 0}};
  EXPECT_EQ(water_light_problem(scene, lamp), "light 'lamp' is not above the water");
  lamp.kind = LightKind::spot;
  EXPECT_EQ(water_light_problem(scene, lamp), "light 'lamp' is neither directional nor a point");
}

}  // namespace
}  // namespace lightbench
