#include "renderer/radiance/chart_atlas.h"

#include <algorithm>
#include <cstdio>
#include <random>
#include <set>

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"
#include "tests/renderer/radiance/chart_meshes.h"

namespace lightbench {
namespace {

using testing::HasSubstr;

ChartAtlas charts_of(const Mesh& mesh, const AtlasSize& size) {
  return make_chart_atlas(mesh, glm::mat4(1), size, AtlasUvs::charts, "object 'it'");
}

std::size_t chart_count(const ChartAtlas& atlas) {
  std::set<std::uint32_t> charts(atlas.charts.begin(), atlas.charts.end());
  charts.erase(kNoChart);
  return charts.size();
}

std::string message_of(const Mesh& mesh, const AtlasSize& size, AtlasUvs uvs) {
  try {
    make_chart_atlas(mesh, glm::mat4(1), size, uvs, "object 'it'");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ChartAtlas, AQuadTakesTheWholeTexture) {
  const Mesh quad = quad_mesh({0, 0, 0}, {7, 0, 0}, {0, 5, 0});
  const ChartAtlas atlas = charts_of(quad, glm::ivec2(8, 6));
  ASSERT_EQ(atlas.surface.size(), 8u * 6u);
  EXPECT_TRUE(atlas.gutters.empty());
  // Corners are texel centres, so a texel is a whole unit here; at which corner it begins is free.
  const glm::dvec3 first =
      surface_point(quad, atlas.surface[0].triangle, {atlas.surface[0].beta, atlas.surface[0].gamma});
  for (const SurfaceTexel& texel : atlas.surface) {
    const glm::dvec3 p = surface_point(quad, texel.triangle, {texel.beta, texel.gamma});
    EXPECT_NEAR(std::abs(p.x - first.x), texel.place.x, 1e-5);  // rounding of barycentrics in floats
    EXPECT_NEAR(std::abs(p.y - first.y), texel.place.y, 1e-5);
  }
}

TEST(ChartAtlas, AQuadIsStretchedToAnyShapeOfTexture) {
  const Mesh quad = quad_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(charts_of(quad, glm::ivec2(200, 100)).surface.size(), 20000u);
  EXPECT_EQ(charts_of(quad, glm::ivec2(30, 100)).surface.size(), 3000u);
}

TEST(ChartAtlas, ATriangleHasItsHypotenuseInTheTextureAndGuttersBeyond) {
  const Mesh triangle = mesh_of({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, {{0, 1, 2}});
  const ChartAtlas atlas = charts_of(triangle, glm::ivec2(4, 4));
  EXPECT_EQ(atlas.surface.size(), 4u + 3u + 2u + 1u);
  EXPECT_EQ(atlas.gutters.size(), 3u);  // one for each cell that the hypotenuse cuts in two
}

TEST(ChartAtlas, DensityGivesTexelsPerUnitOfWorldSpace) {
  const Mesh quad = quad_mesh({0, 0, 0}, {2, 0, 0}, {0, 1, 0});
  const glm::mat4 twice = glm::scale(glm::mat4(1), glm::vec3(2));
  const ChartAtlas atlas = make_chart_atlas(quad, twice, TexelsPerUnit{10}, AtlasUvs::charts, "");
  EXPECT_EQ(atlas.width, 2 * 2 * 10 + 1);
  EXPECT_EQ(atlas.height, 2 * 10 + 1);
}

TEST(ChartAtlas, ACubeHasSixCharts) {
  const ChartAtlas atlas = charts_of(cube_mesh(), glm::ivec2(96, 64));
  EXPECT_EQ(chart_count(atlas), 6u);
  EXPECT_EQ(atlas.surface.size(), 96u * 64u);  // six squares of 32 texels
}

TEST(ChartAtlas, ItsTextureIsAboutSquare) {
  const ChartAtlas atlas = charts_of(cube_mesh(), TexelsPerUnit{31});
  EXPECT_LE(std::max(atlas.width, atlas.height), 96);
  EXPECT_GE(std::min(atlas.width, atlas.height), 64);
}

TEST(ChartAtlas, TrianglesWithoutAreaGetAPlaceOnTheSurfaceNextToThem) {
  const Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}, {3, 3, 3}});
  const ChartAtlas atlas = charts_of(mesh, glm::ivec2(16, 16));
  EXPECT_EQ(atlas.charts[1], kNoChart);
  EXPECT_THAT(atlas.coordinates[0], testing::Contains(atlas.coordinates[1][0]));
  EXPECT_EQ(atlas.coordinates[1][0], atlas.coordinates[1][2]);
  const auto is_there = [&](const SurfaceTexel& t) {
    return glm::vec2(t.place) + 0.5f == atlas.coordinates[2][0];
  };
  EXPECT_TRUE(std::ranges::any_of(atlas.surface, is_there));
}

TEST(ChartAtlas, AnObjectWithoutAreaIsEmpty) {
  const Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}});
  EXPECT_TRUE(charts_of(mesh, glm::ivec2(4, 3)).surface.empty());
  EXPECT_EQ(charts_of(mesh, TexelsPerUnit{3}).width, 1);
}

TEST(ChartAtlas, TellsWhichSizeWouldDo) {
  const Mesh sphere = sphere_mesh(8, 16);
  const std::string message = message_of(sphere, glm::ivec2(5, 6), AtlasUvs::charts);
  EXPECT_THAT(message, HasSubstr("object 'it': "));
  EXPECT_THAT(message, HasSubstr("do not fit into 5 x 6 texels; "));
  glm::ivec2 size;
  ASSERT_EQ(std::sscanf(message.c_str() + message.find("; "), "; %d x %d", &size.x, &size.y), 2);
  EXPECT_NO_THROW(charts_of(sphere, size));
}

TEST(ChartAtlas, TellsWhichDensityWouldDo) {
  const std::string message = message_of(cube_mesh(), TexelsPerUnit{1e5f}, AtlasUvs::charts);
  EXPECT_THAT(message, HasSubstr("more than 16384 x 16384 texels; up to "));
  float density = 0;
  ASSERT_EQ(std::sscanf(message.c_str() + message.find("up to "), "up to %f would do", &density), 1);
  EXPECT_LE(density, 16384 / 3);          // two rows of three squares each
  EXPECT_GE(density, 0.999 * 16384 / 3);  // the search's steps, and four digits
}

TEST(ChartAtlas, RejectsSizesThatAreNone) {
  EXPECT_THAT(message_of(cube_mesh(), glm::ivec2(0, 5), AtlasUvs::charts),
              HasSubstr("each side is 1 to 16384"));
  EXPECT_THAT(message_of(cube_mesh(), TexelsPerUnit{-1}, AtlasUvs::charts),
              HasSubstr("not a positive number"));
}

TEST(ChartAtlas, UsesOwnUvsOnlyWhereTheyCanServe) {
  Mesh quad = quad_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_FALSE(make_chart_atlas(quad, glm::mat4(1), glm::ivec2(8), AtlasUvs::automatic, "").own_uvs);
  EXPECT_THAT(message_of(quad, glm::ivec2(8), AtlasUvs::own), HasSubstr("cannot serve: it has no UVs"));
  quad.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_TRUE(make_chart_atlas(quad, glm::mat4(1), glm::ivec2(8), AtlasUvs::automatic, "").own_uvs);
}

TEST(ChartAtlas, GreatestVIsInRowZero) {
  Mesh quad = quad_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  quad.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const ChartAtlas atlas = make_chart_atlas(quad, glm::mat4(1), glm::ivec2(8, 6), AtlasUvs::own, "");
  EXPECT_EQ(atlas.coordinates[0][0], glm::vec2(0.5f, 5.5f));
  EXPECT_EQ(atlas.coordinates[0][2], glm::vec2(7.5f, 0.5f));
}

TEST(ChartAtlas, InsetIsThatManyTexelsFromTheEdges) {
  const ChartAtlas atlas = charts_of(quad_mesh({0, 0, 0}, {9, 0, 0}, {0, 9, 0}), glm::ivec2(10, 10));
  for (const SurfaceTexel& texel : atlas.surface) {
    const SurfaceTexel moved = inset(atlas, texel, 0.125f);
    const glm::dvec2 p = texel_coordinate(atlas, moved.triangle, {moved.beta, moved.gamma}) - 0.5;
    for (const double x : {p.x, p.y, 9 - p.x, 9 - p.y}) EXPECT_GT(x, 0.125 - 1e-5);  // rounding of floats
    EXPECT_LT(glm::distance(p, glm::dvec2(texel.place)), 0.5);
  }
}

TEST(ChartAtlas, StatisticsCountAllTexels) {
  const Mesh mesh = mesh_of({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, {{0, 1, 2}});
  const AtlasStatistics statistics = atlas_statistics(charts_of(mesh, glm::ivec2(4, 4)), mesh, glm::mat4(2));
  EXPECT_EQ(statistics.surface, 10u);
  EXPECT_EQ(statistics.gutter, 3u);
  EXPECT_EQ(statistics.empty, 3u);
  EXPECT_NEAR(statistics.least_area, 4, 1e-5);  // texels of 2 x 2 in world space
  EXPECT_NEAR(statistics.most_area, 4, 1e-5);
}

double used(const Mesh& mesh, const glm::ivec2& size) {
  const AtlasStatistics statistics = atlas_statistics(charts_of(mesh, size), mesh, glm::mat4(1));
  return double(statistics.surface + statistics.gutter) / (double(size.x) * size.y);
}

TEST(ChartAtlas, AHundredThousandTrianglesFillTheirTexture) {
  EXPECT_GT(used(sphere_mesh(224, 224), {1024, 1024}), 0.99);
}

TEST(ChartAtlas, UnlikeTrianglesFillTheirTexture) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> part(-1, 1);
  std::vector<glm::vec3> positions(9000);
  for (glm::vec3& p : positions) p = {part(random), part(random), part(random)};
  std::vector<glm::uvec3> triangles;
  for (std::uint32_t i = 0; i < positions.size(); i += 3) triangles.emplace_back(i, i + 1, i + 2);
  EXPECT_GT(used(mesh_of(positions, triangles), {512, 512}), 0.93);
}

float coordinate() {
  return float(*rc::gen::inRange(-100, 101)) / 10;
}

/// Some triangles share vertices and edges, some are needles, some have no area; the scale is anything.
Mesh arbitrary_mesh() {
  const int count = *rc::gen::inRange(1, 40), vertices = *rc::gen::inRange(3, 40);
  const float scale = std::pow(10.0f, float(*rc::gen::inRange(-12, 12)));
  const float depth = *rc::gen::element(0.0f, 1e-5f, 1e-2f, 1.0f);
  std::vector<glm::vec3> positions;
  for (int i = 0; i < vertices; ++i)
    positions.push_back(scale * glm::vec3(coordinate(), depth * coordinate(), coordinate()));
  std::vector<glm::uvec3> triangles;
  for (int i = 0; i < count; ++i) {
    const auto vertex = [&] { return std::uint32_t(*rc::gen::inRange(0, vertices)); };
    triangles.emplace_back(vertex(), vertex(), vertex());
  }
  Mesh mesh = mesh_of(positions, triangles);
  const int quads = *rc::gen::inRange(0, 6);
  for (int i = 0; i < quads; ++i)
    append(mesh, quad_mesh(scale * glm::vec3(coordinate()), {scale * coordinate(), scale * coordinate(), 0},
                           {0, scale * coordinate(), scale}));
  return mesh;
}

void check_lookups(const Mesh& mesh, const ChartAtlas& atlas) {
  const FilledAtlas filled(atlas, [](std::uint32_t, const glm::dvec2&) { return 0.0; });
  RC_ASSERT(filled.is_clean());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 4 && atlas.charts[t] != kNoChart; ++i)
      RC_ASSERT(filled.holds(texel_coordinate(atlas, t, arbitrary_barycentrics()), atlas.charts[t]));
}

void check_surface(const ChartAtlas& atlas) {
  for (const SurfaceTexel& texel : atlas.surface) {
    RC_ASSERT(texel.beta >= 0 && texel.gamma >= 0 && texel.beta + texel.gamma < 1 + 1e-6f);
    const glm::dvec2 p = texel_coordinate(atlas, texel.triangle, {texel.beta, texel.gamma});
    RC_ASSERT(glm::distance(p, glm::dvec2(texel.place) + 0.5) < 1e-3);  // rounding of beta times a long leg
  }
}

RC_GTEST_PROP(ChartAtlas, LookupsStayInTheirChart, ()) {
  const Mesh mesh = arbitrary_mesh();
  const bool given = *rc::gen::arbitrary<bool>();
  const glm::ivec2 size(*rc::gen::inRange(40, 200), *rc::gen::inRange(40, 200));
  float largest = 0;
  for (const glm::vec3& p : mesh.positions)
    for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(p[i]));
  RC_PRE(largest > 0);
  const TexelsPerUnit density{float(*rc::gen::inRange(1, 100)) / largest};
  const ChartAtlas atlas = charts_of(mesh, given ? AtlasSize(size) : AtlasSize(density));
  check_lookups(mesh, atlas);
  check_surface(atlas);
}

RC_GTEST_PROP(ChartAtlas, LookupsInOwnUvsStayInTheirChart, ()) {
  Mesh sphere = sphere_mesh(*rc::gen::inRange(3, 9), *rc::gen::inRange(3, 9));
  for (glm::vec2& uv : sphere.uvs) uv += 0.04f * glm::vec2(uv.y, 0.3f * uv.x * uv.x);
  for (glm::vec2& uv : sphere.uvs) uv /= 1.1f;
  const AtlasSize size = glm::ivec2(*rc::gen::inRange(10, 90), *rc::gen::inRange(10, 90));
  RC_PRE(why_not_own_uvs(sphere, glm::mat4(1), size).empty());  // points of cusps may miss all texels
  const ChartAtlas atlas = make_chart_atlas(sphere, glm::mat4(1), size, AtlasUvs::own, "");
  check_lookups(sphere, atlas);
  check_surface(atlas);
}

/// On all triangles: halves and pairs that are parallelograms are affine maps, and gutters extrapolate them.
RC_GTEST_PROP(ChartAtlas, LinearFunctionsAreLookedUpExactly, ()) {
  Mesh mesh;
  const int count = *rc::gen::inRange(1, 10);
  for (int i = 0; i < count; ++i) {
    const glm::vec3 u(10 + coordinate(), coordinate(), 0.1f), v(coordinate(), 0, 12 + coordinate());
    Mesh piece = quad_mesh({coordinate(), coordinate(), float(50 * i)}, u, v);
    if (*rc::gen::arbitrary<bool>()) piece.triangles.pop_back();
    append(mesh, piece);
  }
  const ChartAtlas atlas = charts_of(mesh, TexelsPerUnit{float(*rc::gen::inRange(1, 40)) / 10});
  const auto value = [&](std::size_t triangle, const glm::dvec2& b) {
    const glm::dvec3 p = surface_point(mesh, triangle, b);
    return 1 + 0.3 * p.x - 0.2 * p.y + 0.1 * p.z;
  };
  const FilledAtlas filled(atlas, value);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::dvec2 b = arbitrary_barycentrics();
    // Rounding of positions (up to 500) and barycentrics in floats, and lookups' weights taken for 0.
    RC_ASSERT(std::abs(filled.lookup(texel_coordinate(atlas, t, b)) - value(t, b)) < 5e-3);
  }
}

}  // namespace
}  // namespace lightbench
