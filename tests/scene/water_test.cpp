#include "scene/water.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "scene_test_files.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

Water wavy_water() {
  Water water;
  water.min = {-2, -1};
  water.max = {3, 4};
  water.height = 1.5f;
  water.grid = {11, 6};
  water.waves = {{0.1f, 2.0f, glm::normalize(glm::vec2(1, 2)), 0.5f, 0.3f}, {0.04f, 0.7f, {-1, 0}, -1, 2}};
  return water;
}

double share() {
  return *rc::gen::inRange(0, 1001) / 1000.0;
}

TEST(Water, IsTheSumOfItsWaves) {
  Water water;
  water.height = 2;
  water.waves = {{0.5f, 4, {1, 0}, 2, 0}, {0.25f, 8, {0, 1}, 0, glm::half_pi<float>()}};
  EXPECT_NEAR(water_level(water, {1, 0}, 0), 2 + 0.5 + 0.25, 1e-7);
  EXPECT_NEAR(water_level(water, {1, 2}, 0), 2 + 0.5, 1e-7);
  EXPECT_NEAR(water_level(water, {1, 4}, 0), 2 + 0.5 - 0.25, 1e-7);
  // Half a second later the first wave has run on by one unit.
  EXPECT_NEAR(water_level(water, {2, 0}, 0.5), 2 + 0.5 + 0.25, 1e-7);
}

RC_GTEST_PROP(Water, NormalsAreThoseOfItsShape, ()) {
  const Water water = wavy_water();
  const glm::dvec2 place(5 * share() - 2, 5 * share() - 1);
  const double time = 3 * share(), step = 1e-5;
  const auto point = [&](double x, double z) {
    const glm::dvec2 at = place + glm::dvec2(x, z);
    return glm::dvec3(at.x, water_level(water, at, time), at.y);
  };
  const glm::dvec3 across = glm::cross(point(0, step) - point(0, -step), point(step, 0) - point(-step, 0));
  // Differences of a step of 1e-5 are off by the third derivatives: a k^3 step^2, below 1e-8.
  RC_ASSERT(glm::length(glm::normalize(across) - water_normal(water, place, time)) < 1e-7);
}

TEST(Water, MeshCoversTheRectangleAndLooksUp) {
  const Water water = wavy_water();
  const Mesh mesh = water_mesh(water, 0.25);
  ASSERT_EQ(mesh.positions.size(), 66u);
  ASSERT_EQ(mesh.triangles.size(), 100u);
  EXPECT_EQ(glm::vec2(mesh.positions.front().x, mesh.positions.front().z), water.min);
  EXPECT_EQ(glm::vec2(mesh.positions.back().x, mesh.positions.back().z), water.max);
  double area = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
    const glm::vec3 normal = glm::cross(b - a, c - a);
    EXPECT_GT(normal.y, 0);
    area += 0.5 * double(normal.y);
  }
  EXPECT_NEAR(area, 25, 1e-4);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_NEAR(double(mesh.positions[i].y),
                water_level(water, {mesh.positions[i].x, mesh.positions[i].z}, 0.25), 1e-5);
}

TEST(Water, FocusesAtTheDepthOfStrengthOne) {
  // Rays from straight above through both sides of a crest meet at the depth where 0.25 depth a k^2 is 1; for
  // small slopes, and ior 4/3, for which 0.25 is 1 - 1 / ior.
  Water water;
  water.ior = 4.0f / 3;
  water.waves = {{0.001f, 1, {1, 0}, 0, 0}};
  const double crest = 0.25, off = 0.01;
  const auto ray = [&](double x) { return *refracted({0, -1, 0}, water_normal(water, {x, 0}, 0), 0.75); };
  const glm::dvec3 left = ray(crest - off);
  const double depth = off / left.x * -left.y;
  EXPECT_NEAR(focusing_strength(water, depth), 1, 0.002);
}

RC_GTEST_PROP(Refracted, ObeysSnell, ()) {
  const double in = glm::half_pi<double>() * share() * 0.999, ratio = 0.4 + 2 * share();
  const glm::dvec3 normal = glm::normalize(glm::dvec3(share() - 0.5, 1, share() - 0.5));
  const glm::dvec3 along = glm::normalize(glm::cross(normal, glm::dvec3(1, 0, 0)));
  const glm::dvec3 direction = -std::cos(in) * normal + std::sin(in) * along;
  const auto beyond = refracted(direction, normal, ratio);
  if (ratio * std::sin(in) > 1) {
    RC_ASSERT(!beyond);
    RC_ASSERT(fresnel_transmission(direction, normal, ratio) == 0);
    return;
  }
  RC_ASSERT(beyond.has_value());
  RC_ASSERT(std::abs(glm::length(*beyond) - 1) < 1e-12);
  RC_ASSERT(std::abs(glm::dot(*beyond, along) - ratio * std::sin(in)) < 1e-9);
  RC_ASSERT(glm::dot(*beyond, normal) <= 0);
  // As much passes the other way.
  const double back = fresnel_transmission(-*beyond, -normal, 1 / ratio);
  RC_ASSERT(std::abs(fresnel_transmission(direction, normal, ratio) - back) < 1e-6);
}

TEST(FresnelTransmission, AtRightAngles) {
  // 4 n / (n + 1)^2
  EXPECT_NEAR(fresnel_transmission({0, -1, 0}, {0, 1, 0}, 1 / 1.333), 4 * 1.333 / (2.333 * 2.333), 1e-12);
}

TEST(WaterInASceneFile, IsRead) {
  const SceneTestFiles files;
  const LoadedScene loaded = load_square(files, R"(, "water": {"min": [-1, -2], "max": [1, 2], "height": 3,
      "grid": [5, 9], "ior": 1.4, "absorption": [0.1, 0.2, 0.3], "ambient": [0.05, 0.06, 0.07],
      "waves": [{"amplitude": 0.1, "wavelength": 2, "direction": [0, -3], "speed": 0.5, "phase": 90}]})");
  EXPECT_EQ(error_count(loaded), 0u) << described(loaded, files);
  ASSERT_TRUE(loaded.scene.water);
  const Water& water = *loaded.scene.water;
  EXPECT_EQ(water.max, glm::vec2(1, 2));
  EXPECT_EQ(water.height, 3);
  EXPECT_EQ(water.grid, glm::ivec2(5, 9));
  EXPECT_EQ(water.ior, 1.4f);
  EXPECT_EQ(water.absorption, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(water.ambient, glm::vec3(0.05f, 0.06f, 0.07f));
  ASSERT_EQ(water.waves.size(), 1u);
  EXPECT_EQ(water.waves[0].direction, glm::vec2(0, -1));
  EXPECT_NEAR(water.waves[0].phase, glm::half_pi<float>(), 1e-6f);
}

struct BadWater {
  const char* name;
  const char* keys;  ///< beside min, max and height
  const char* problem;
};

void PrintTo(const BadWater& bad, std::ostream* stream) {
  *stream << bad.name;
}

class BadWaterOfASceneFile : public ::testing::TestWithParam<BadWater> {};

TEST_P(BadWaterOfASceneFile, IsListedWithItsPath) {
  const SceneTestFiles files;
  const std::string water = R"(, "water": {"min": [0, 0], "max": [1, 1], "height": 0)";
  EXPECT_THAT(described(load_square(files, water + GetParam().keys + "}"), files),
              HasSubstr("s.json: $.water" + std::string(GetParam().problem)));
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BadWaterOfASceneFile,
    ::testing::Values(
        BadWater{"UnknownKey", R"(, "wave": [])", ": unknown key 'wave' (did you mean 'waves'?)"},
        BadWater{"OneVertex", R"(, "grid": [1, 5])",
                 ".grid: a grid has 2 to 2048 vertices along an edge, not 1"},
        BadWater{"HalfAVertex", R"(, "grid": [2.5, 5])", ".grid: a grid has 2 to 2048"},
        BadWater{"HugeGrid", R"(, "grid": [2, 1e9])", ".grid: a grid has 2 to 2048"},
        BadWater{"ThreeCounts", R"(, "grid": [2, 2, 2])", ".grid: must be a list of 2"},
        BadWater{"ThinnerThanAir", R"(, "ior": 0.9)", ".ior: must be between"},
        BadWater{"GrowingLight", R"(, "absorption": [0, -1, 0])", ".absorption: a colour must lie"},
        BadWater{"WavesOfOneObject", R"(, "waves": {})", ".waves: must be a list"},
        BadWater{"NoAmplitude", R"(, "waves": [{"wavelength": 1, "direction": [1, 0]}])",
                 ".waves[0]: the key 'amplitude' is missing"},
        BadWater{"NoLength", R"(, "waves": [{"amplitude": 1, "wavelength": 0, "direction": [1, 0]}])",
                 ".waves[0].wavelength: must be between"},
        BadWater{"NoDirection", R"(, "waves": [{"amplitude": 1, "wavelength": 1, "direction": [0, 0]}])",
                 ".waves[0].direction: a direction must not be zero"},
        BadWater{"DirectionInSpace",
                 R"(, "waves": [{"amplitude": 1, "wavelength": 1, "direction": [1, 0, 0]}])",
                 ".waves[0].direction: must be a list of 2"},
        BadWater{"CoarseGrid",
                 R"(, "grid": [5, 5], "waves": [{"amplitude": 1, "wavelength": 0.9, "direction": [1, 0]}])",
                 ": wave 0 has fewer than 4 of the water's vertices on a length"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(WaterInASceneFile, EmptyWaterIsAProblem) {
  const SceneTestFiles files;
  EXPECT_THAT(
      described(load_square(files, R"(, "water": {"min": [0, 0], "max": [1, 0], "height": 0})"), files),
      HasSubstr("error s.json: $.water.max: the water is empty"));
  EXPECT_THAT(described(load_square(files, R"(, "water": {"min": [0, 0], "max": [1, 1]})"), files),
              HasSubstr("error s.json: $.water: the key 'height' is missing"));
  EXPECT_THAT(described(load_square(files, R"(, "water": 7)"), files),
              HasSubstr("error s.json: $.water: must be an object"));
}

}  // namespace
}  // namespace lightbench
