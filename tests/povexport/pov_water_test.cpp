#include "povexport/pov_water.h"

#include <gmock/gmock.h>

#include "pov_test_scenes.h"
#include "scene/box_mesh.h"

namespace lightbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A floor of albedo 0.5 below flat water, in slanting sun.
Scene pool() {
  Scene scene;
  scene.name = "pool";
  scene.materials = {matte(glm::vec3(0.5f))};
  scene.meshes = {box_mesh("floor", {{-1, -0.1f, -1}, {1, 0, 1}}, 0)};
  scene.entities = {{"floor", 0}};
  Light sun;
  sun.name = "sun";
  sun.kind = LightKind::directional;
  sun.direction = glm::normalize(glm::vec3(3, -4, 0));
  scene.lights = {sun};
  Water water;
  water.min = {-3, -3};
  water.max = {3, 3};
  water.height = 1;
  water.grid = {3, 3};
  scene.water = water;
  return scene;
}

std::string water_text(const Scene& scene, bool fresnel = false) {
  return pov_water(scene, {world_bounds(scene), 2}, fresnel).text();
}

TEST(PovWater, IsAMeshThatRefractsPhotons) {
  const std::string text = water_text(pool());
  EXPECT_THAT(text,
              AllOf(HasSubstr("vertex_vectors{9\n"), HasSubstr("face_indices{8\n"), HasSubstr("ior 1.333"),
                    HasSubstr("<-6,2,-6>"), HasSubstr("photons{target refraction on"), HasSubstr("hollow")));
  EXPECT_THAT(text, AllOf(Not(HasSubstr("media")), Not(HasSubstr("reflection{"))));
  EXPECT_THAT(water_text(pool(), true), HasSubstr("reflection{0 1 fresnel}conserve_energy"));
}

TEST(PovWater, AbsorbsByPovRaysUnits) {
  Scene scene = pool();
  scene.water->absorption = {1, 0.5f, 0.25f};
  EXPECT_THAT(water_text(scene), HasSubstr("media{absorption rgb<0.5,0.25,0.125>}"));
}

TEST(PovWater, MovesWithTime) {
  Scene scene = pool();
  scene.water->waves = {{0.1f, 1.5f, {1, 0}, 1, 0}};
  const std::string still = water_text(scene);
  scene.time = 0.4;
  EXPECT_NE(water_text(scene), still);
}

TEST(PovWater, OnlyScenesWithWaterHavePhotons) {
  Scene scene = pool();
  const auto view = [&] { return pov_view(scene, pov_assets(scene), facing_camera(), 1, {}); };
  EXPECT_THAT(view(),
              AllOf(HasSubstr("photons{spacing"), HasSubstr("photons{refraction on reflection off}")));
  scene.water.reset();
  EXPECT_THAT(view(), Not(HasSubstr("photons")));
}

/// The red, green and blue of the middle of the floor, seen from below the water.
glm::vec3 floor_by_povray(const Scene& scene) {
  Camera camera;
  camera.position = {0, 0.9f, 0};
  camera.look_at = {0, 0, 0};
  camera.up = {0, 0, -1};
  camera.fov = 0.5f;
  PovOptions options = direct_options();
  options.photon_spacing = 2e-3;
  const Image image = render(scene, camera, options);
  glm::vec3 sum(0);
  for (std::size_t i = 0; i < image.data.size(); i += 4)
    sum += glm::vec3(image.data[i], image.data[i + 1], image.data[i + 2]);
  return sum / float(image.pixel_count());
}

TEST(PovrayWater, FlatWaterLightsAsTheCosinesAndTheWaySay) {
  Scene scene = pool();
  scene.water->absorption = {0, 0.5f, 1};
  const double sine = 0.6 / double(scene.water->ior), way = 1 / std::sqrt(1 - sine * sine);
  const glm::vec3 floor = floor_by_povray(scene);
  // A hundred photons around each pixel's place: their mean over the picture is good to a hundredth.
  EXPECT_NEAR(double(floor.r), 0.5 * 0.8, 0.005);
  EXPECT_NEAR(double(floor.g), 0.5 * 0.8 * std::exp(-0.5 * way), 0.005);
  EXPECT_NEAR(double(floor.b), 0.5 * 0.8 * std::exp(-way), 0.005);
}

TEST(PovrayWater, AmbientLightIsAdded) {
  Scene scene = pool();
  scene.lights.clear();
  scene.water->ambient = {0.2f, 0.4f, 0.6f};
  const glm::vec3 floor = floor_by_povray(scene);
  EXPECT_NEAR(double(floor.r), 0.1, 1e-3);
  EXPECT_NEAR(double(floor.b), 0.3, 1e-3);
}

}  // namespace
}  // namespace lightbench
