#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "scene/mesh_builder.h"
#include "scene/obj_loader.h"
#include "scene/obj_parser.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

namespace fs = std::filesystem;

struct RealScene {
  const char* file;
  std::size_t triangles;  ///< in the file
  std::size_t textures;
};

void PrintTo(const RealScene& scene, std::ostream* stream) {
  *stream << scene.file;
}

constexpr RealScene kScenes[] = {
    {"simple/bathroom/bathroom.obj", 15612, 7},
    {"simple/bungalow/village_vil_bungalow.obj", 18156, 85},
    {"simple/car_studio/car_studio.obj", 12236, 2},
    {"simple/cornell_box/cornell_box.obj", 36, 0},
    {"simple/fortmagma/fortmagma.obj", 15509, 35},
    {"simple/garage/garage.obj", 23469, 8},
    {"simple/harbour/harbour.obj", 19963, 62},
    {"simple/livingroom/livingroom.obj", 20864, 7},
    {"simple/mine/mine.obj", 23444, 34},
    {"simple/office/office.obj", 24840, 9},
    {"simple/primitives/primitives.obj", 5700, 0},
    {"simple/silvercity/silvercity.obj", 13301, 12},
    {"simple/xr591/xr591.obj", 22274, 32},
    {"complex/cornfield_crossing/cornfield_crossing.obj", 330434, 84},
    {"complex/hacienda/hacienda.obj", 37941, 58},
    {"complex/kitchen_complex/kitchen_complex.obj", 356162, 10},
    {"complex/mansion/mansion_mansion_main.obj", 62183, 137},
    {"complex/office_tower/city2_c2_main.obj", 98000, 110},
    {"complex/olivermath/olivermath.obj", 49384, 36},
    {"complex/ons-reborn/ons-reborn.obj", 125091, 62},
    {"complex/saloon/saloon.obj", 448733, 11},
    {"complex/small_street/small_street.obj", 41424, 126},
};

// The folder, or nothing: then the test is skipped, or fails where the scenes are required.
fs::path scenes_folder() {
  const char* folder = std::getenv("LIGHTBENCH_SCENES");
  return folder && fs::is_directory(folder) ? fs::path(folder) : fs::path();
}
bool are_scenes_required() {
  const char* required = std::getenv("LIGHTBENCH_REQUIRE_SCENES");
  return required && std::string(required) == "1";
}

class RealScenes : public ::testing::TestWithParam<RealScene> {
 protected:
  void SetUp() override {
    if (!scenes_folder().empty()) return;
    if (are_scenes_required()) FAIL() << "LIGHTBENCH_SCENES is not a folder";
    GTEST_SKIP() << "LIGHTBENCH_SCENES is not set: " << GetParam().file;
  }
  fs::path file() const { return scenes_folder() / GetParam().file; }
};

void expect_sound(const Mesh& mesh, const Scene& scene) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  ASSERT_TRUE(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
  std::uint32_t covered = 0;
  for (const MeshPart& part : mesh.parts) {
    ASSERT_EQ(part.first_triangle, covered);
    ASSERT_LT(std::size_t(part.material), scene.materials.size());
    covered += part.triangle_count;
  }
  ASSERT_EQ(covered, mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ASSERT_LT(t[k], mesh.positions.size());
  for (const glm::vec3& n : mesh.normals)
    ASSERT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1.0f, 1e-5f) << "rounding of a normalised float vector";
}

TEST_P(RealScenes, LoadWithoutErrors) {
  const LoadedScene loaded = load_scene_collecting(file());
  for (const Problem& p : loaded.problems)
    EXPECT_NE(p.severity, Problem::Severity::error) << p.where << ": " << p.what;
  EXPECT_GE(loaded.scene.textures.size(), GetParam().textures);
  EXPECT_FALSE(world_bounds(loaded.scene).empty());
  for (const Mesh& mesh : loaded.scene.meshes) expect_sound(mesh, loaded.scene);
}

TEST_P(RealScenes, LoseNoTriangleUncounted) {
  ProblemList problems;
  const ObjData data = parse_obj(file(), problems);
  MeshOptions options;
  options.material_has_cutout.resize(data.materials.size());
  const BuiltMeshes built = build_meshes(data, options);
  std::size_t kept = 0;
  for (const Mesh& mesh : built.meshes) kept += mesh.triangles.size();
  EXPECT_EQ(kept + built.statistics.degenerate_triangles + built.statistics.duplicate_triangles,
            GetParam().triangles);
  // The least is cornfield_crossing's: an eighth of its faces stands twice, as single-sided leaves do.
  EXPECT_GT(double(kept), 0.8 * double(GetParam().triangles));
}

INSTANTIATE_TEST_SUITE_P(All, RealScenes, ::testing::ValuesIn(kScenes), [](const auto& test) {
  std::string name = fs::path(test.param.file).stem().string();
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

}  // namespace
}  // namespace lightbench
