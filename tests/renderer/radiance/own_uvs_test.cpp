#include "renderer/radiance/own_uvs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/radiance/texel_cover.h"
#include "tests/renderer/radiance/chart_meshes.h"

namespace lightbench {
namespace {

using testing::HasSubstr;

/// Of 1 x 1, with its UVs in a box.
Mesh quad_with_uvs(const glm::vec2& low, const glm::vec2& high) {
  Mesh quad = quad_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  quad.uvs = {low, {high.x, low.y}, high, {low.x, high.y}};
  return quad;
}

/// Beside one another.
Mesh two_quads(float gap) {
  Mesh mesh = quad_with_uvs({0, 0}, {0.5f, 1});
  Mesh other = quad_with_uvs({0.5f + gap, 0}, {1, 1});
  for (glm::vec3& p : other.positions) p.x += 3;
  append(mesh, other);
  return mesh;
}

std::string problem(const Mesh& mesh, const glm::ivec2& size) {
  return why_not_own_uvs(mesh, glm::mat4(1), size);
}

TEST(OwnUvs, AreStretchedToTheOutermostTexelCentres) {
  const OwnUvs own = place_own_uvs(quad_with_uvs({0.2f, 0.4f}, {0.3f, 0.6f}), {11, 5}, {false, false});
  EXPECT_EQ(own.coordinates[0][0], glm::vec2(0.5f, 4.5f));
  EXPECT_EQ(own.coordinates[0][2], glm::vec2(10.5f, 0.5f));
}

TEST(OwnUvs, TrianglesThatShareAnEdgeAreOneChart) {
  const OwnUvs own = place_own_uvs(two_quads(0), {8, 8}, {false, false, false, false});
  EXPECT_EQ(own.charts[0], own.charts[1]);
  EXPECT_EQ(own.charts[2], own.charts[3]);
  EXPECT_NE(own.charts[0], own.charts[2]);
}

TEST(OwnUvs, TrianglesWithoutAreaAreOfNoChart) {
  EXPECT_EQ(place_own_uvs(two_quads(0), {8, 8}, {false, true, false, false}).charts[1], kNoChart);
}

TEST(OwnUvs, ServeWhereThePiecesAreApart) {
  EXPECT_EQ(problem(quad_with_uvs({0, 0}, {1, 1}), {16, 16}), "");
  EXPECT_EQ(problem(two_quads(0.125f), {33, 33}), "");  // four texels apart
  EXPECT_THAT(problem(two_quads(0), {33, 33}), HasSubstr("too close to each other"));
  EXPECT_EQ(problem(two_quads(0.125f), {9, 9}), "");  // they end in neighbouring texel centres
  EXPECT_THAT(problem(two_quads(0.125f), {12, 12}),
              HasSubstr("too close to each other"));  // on both sides of one
}

TEST(OwnUvs, DoNotServeWhereTrianglesOverlap) {
  // A quad folded back onto itself in its UVs: one piece.
  Mesh quad = quad_with_uvs({0, 0}, {1, 1});
  quad.uvs[3] = {0.9f, 0.1f};
  EXPECT_THAT(problem(quad, {16, 16}), HasSubstr("triangles 0 and 1 overlap at texel"));
}

TEST(OwnUvs, DoNotServeOutsideOfTheUnitSquare) {
  EXPECT_THAT(problem(quad_with_uvs({0, 0}, {1.5f, 1}), {16, 16}), HasSubstr("UV (1.5, 0) of triangle 0"));
  EXPECT_THAT(problem(quad_with_uvs({std::nanf(""), 0}, {1, 1}), {16, 16}), HasSubstr("outside [0, 1]"));
}

TEST(OwnUvs, DoNotServeWithoutArea) {
  EXPECT_THAT(problem(quad_with_uvs({0, 0.5f}, {1, 0.5f}), {16, 16}), HasSubstr("triangle 0 has no area"));
}

TEST(OwnUvs, DoNotServeWherePiecesMissAllTexels) {
  Mesh mesh = quad_with_uvs({0, 0}, {0.5f, 1});
  append(mesh, quad_with_uvs({0.99f, 0.49f}, {0.995f, 0.495f}));
  append(mesh, quad_with_uvs({0.9f, 1}, {1, 0.99f}));
  EXPECT_THAT(problem(mesh, {32, 32}), HasSubstr("too small for this size"));
}

TEST(OwnUvs, DoNotServeInOneRow) {
  EXPECT_THAT(problem(quad_with_uvs({0, 0}, {1, 1}), {16, 1}), HasSubstr("two texels on each side"));
}

TEST(OwnUvs, DensityGivesTexelsPerUnitOfLength) {
  const Mesh quad = quad_with_uvs({0, 0}, {0.5f, 0.25f});
  const glm::mat4 stretch{{4, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  const glm::dvec2 size = size_for_own_uvs(quad, stretch, 10);
  EXPECT_NEAR(size.x, 41, 1e-4);  // rounding of floats
  EXPECT_NEAR(size.y, 31, 1e-4);
}

}  // namespace
}  // namespace lightbench
