// What shows through waves, by technique `caustics` and by POV-Ray's refracted rays: all surfaces have the
// colours of their own places.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "agreement_pair.h"
#include "tests/renderer/caustics/water_scenes.h"

namespace lightbench {
namespace {

using namespace test;

constexpr int kWidth = 160, kHeight = 120;
constexpr float kScale = 4, kOffset = 3;  // places between -3 and 3 as colours

Scene coloured_by_place() {
  Scene scene = ball_in_waves();
  scene.lights.clear();
  scene.water->ambient = glm::vec3(1);
  scene.materials[0].diffuse = glm::vec3(1);
  for (Mesh& mesh : scene.meshes) {
    mesh.colors.clear();
    for (const glm::vec3& place : mesh.positions) mesh.colors.push_back((place + kOffset) / kScale);
  }
  return scene;
}

Image through(const Scene& scene, const View& view) {
  RenderSetup setup;
  setup.technique = "caustics";
  setup.width = kWidth;
  setup.height = kHeight;
  setup.buffers = {"through"};
  return render(scene, view, setup).buffers.at("through");
}

TEST(PovrayWaterView, ShowsThePlacesThatPovRaysRaysMeet) {
  const Scene scene = coloured_by_place();
  const PovAssets assets = pov_assets(scene);
  for (const double degrees : {35, 50, 70, 90}) {
    const View view = looking_down(degrees);
    const Image shown = through(scene, view);
    const Image expected = povray_image(scene, assets, view, {scene, view, kWidth, kHeight, 1, {}});
    int water = 0, wrong = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const auto place = shown.pixel(x, y), color = expected.pixel(x, y);
        const glm::vec3 here(place[0], place[1], place[2]);
        if (here == glm::vec3(0)) continue;
        ++water;
        wrong += glm::distance(here, kScale * glm::vec3(color[0], color[1], color[2]) - kOffset) > 0.02f;
      }
    EXPECT_GT(water, kWidth * kHeight / 2) << degrees;
    EXPECT_LE(wrong, water / 100) << degrees;
    RecordProperty("wrong at " + std::to_string(int(degrees)), wrong);
  }
}

}  // namespace
}  // namespace lightbench
