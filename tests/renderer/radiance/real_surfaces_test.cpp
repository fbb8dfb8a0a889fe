#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "renderer/radiance/chart_atlas.h"
#include "scene/scene_file.h"
#include "tests/renderer/radiance/chart_meshes.h"

namespace lightbench {
namespace {

std::filesystem::path scenes_folder() {
  const char* folder = std::getenv("LIGHTBENCH_SCENES");
  return folder ? folder : "";
}

bool are_scenes_required() {
  const char* required = std::getenv("LIGHTBENCH_REQUIRE_SCENES");
  return required && std::string(required) == "1";
}

class RealSurfaces : public testing::TestWithParam<const char*> {};

/// Ten points of each triangle.
void expect_lookups_to_stay(const Mesh& mesh, const ChartAtlas& atlas) {
  const FilledAtlas filled(atlas, [](std::uint32_t, const glm::dvec2&) { return 0.0; });
  ASSERT_TRUE(filled.is_clean()) << mesh.name;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.001, 0.998);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 10 && atlas.charts[t] != kNoChart; ++i) {
      glm::dvec2 b(part(random), part(random));
      if (b.x + b.y >= 1) b = 0.9999 - b;
      ASSERT_TRUE(filled.holds(texel_coordinate(atlas, t, b), atlas.charts[t])) << mesh.name << " " << t;
    }
}

TEST_P(RealSurfaces, FillTheirTextureAndKeepLookupsApart) {
  if (!std::filesystem::is_directory(scenes_folder())) {
    if (are_scenes_required()) FAIL() << "LIGHTBENCH_SCENES is not a folder";
    GTEST_SKIP() << "LIGHTBENCH_SCENES is not set";
  }
  const Scene scene = load_scene(scenes_folder() / GetParam());
  double used = 0, all = 0;
  for (const Entity& entity : scene.entities) {
    const Mesh& mesh = scene.meshes[std::size_t(entity.mesh)];
    const ChartAtlas least =
        make_chart_atlas(mesh, entity.transform, TexelsPerUnit{1e-6f}, AtlasUvs::charts, entity.name);
    const glm::ivec2 size = 2 * glm::ivec2(least.width, least.height);
    const ChartAtlas atlas = make_chart_atlas(mesh, entity.transform, size, AtlasUvs::automatic, entity.name);
    expect_lookups_to_stay(mesh, atlas);
    used += double(atlas.surface.size() + atlas.gutters.size());
    all += double(atlas.width) * atlas.height;
  }
  RecordProperty("used_percent", int(100 * used / all));
  EXPECT_GT(used / all, 0.6);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RealSurfaces,
                         testing::Values("simple/primitives/primitives.obj",
                                         "simple/cornell_box/cornell_box.obj",
                                         "simple/livingroom/livingroom.obj", "receivers/bunny.obj",
                                         "receivers/teapot.obj", "complex/hacienda/hacienda.obj"),
                         [](const auto& scene) { return std::to_string(scene.index); });

}  // namespace
}  // namespace lightbench
