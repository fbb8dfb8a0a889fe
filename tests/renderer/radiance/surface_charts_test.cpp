#include "renderer/radiance/surface_charts.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "tests/renderer/radiance/chart_meshes.h"

namespace lightbench {
namespace {

std::vector<SurfaceChart> charts_of(const Mesh& mesh) {
  return find_charts(mesh, glm::mat4(1));
}

/// Two triangles over an edge of length 1, as parts of one quad of 1 x 1 whose second half is turned about
/// its diagonal.
Mesh folded_quad(float degrees) {
  const glm::vec3 axis = glm::normalize(glm::vec3(1, 1, 0));
  const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(degrees), axis);
  return mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, glm::vec3(turn * glm::vec4(0, 1, 0, 1))},
                 {{0, 1, 2}, {0, 2, 3}});
}

TEST(SurfaceCharts, AQuadIsOneWithItsSidesAsLegs) {
  const auto charts = charts_of(quad_mesh({1, 2, 3}, {5, 0, 0}, {0, 7, 0}));
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_TRUE(charts[0].second.has_value());
  EXPECT_NEAR(charts[0].u_length, 7, 1e-6);  // the longer one is first
  EXPECT_NEAR(charts[0].v_length, 5, 1e-6);
}

TEST(SurfaceCharts, LengthsAreThoseOfWorldSpace) {
  const glm::mat4 stretch = glm::scale(glm::mat4(1), {10, 1, 1});
  const auto charts = find_charts(quad_mesh({0, 0, 0}, {5, 0, 0}, {0, 7, 0}), stretch);
  EXPECT_NEAR(charts[0].u_length, 50, 1e-5);
  EXPECT_NEAR(charts[0].v_length, 7, 1e-6);
}

TEST(SurfaceCharts, VerticesMayBeDoubled) {
  const Mesh quad =
      mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(charts_of(quad).size(), 1u);
}

TEST(SurfaceCharts, NormalsAtTheEdgeMustAgree) {
  Mesh quad =
      mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  quad.normals[4] = glm::normalize(glm::vec3(0.1f, 0, 1));
  EXPECT_EQ(charts_of(quad).size(), 2u);
}

TEST(SurfaceCharts, TrianglesOfTwoPartsStayApart) {
  Mesh quad = quad_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  quad.parts = {{0, 0, 1}, {1, 1, 1}};
  EXPECT_EQ(charts_of(quad).size(), 2u);
}

TEST(SurfaceCharts, TrianglesThatAreNotCoplanarStayApart) {
  EXPECT_EQ(charts_of(folded_quad(8)).size(), 1u);
  EXPECT_EQ(charts_of(folded_quad(12)).size(), 2u);
  EXPECT_EQ(charts_of(folded_quad(90)).size(), 2u);
}

TEST(SurfaceCharts, OnlyNearParallelogramsAreJoined) {
  const auto trapezoid = [](float top) {
    return mesh_of({{0, 0, 0}, {1, 0, 0}, {top, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  };
  EXPECT_EQ(charts_of(trapezoid(0.8f)).size(), 1u);
  EXPECT_EQ(charts_of(trapezoid(0.7f)).size(), 2u);
  EXPECT_EQ(charts_of(quad_mesh({0, 0, 0}, {1, 0, 0}, {0.9f, 1, 0})).size(), 1u);
  EXPECT_EQ(charts_of(quad_mesh({0, 0, 0}, {1, 0, 0}, {-1.1f, 1, 0})).size(), 2u);
}

TEST(SurfaceCharts, TrianglesThatFaceOppositeWaysStayApart) {
  EXPECT_EQ(charts_of(mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}})).size(),
            2u);
}

TEST(SurfaceCharts, AGridFallsIntoItsQuads) {
  Mesh grid = mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
                      {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}});
  for (const SurfaceChart& chart : charts_of(grid)) {
    ASSERT_TRUE(chart.second.has_value());
    EXPECT_EQ(chart.first.triangle / 2, chart.second->triangle / 2);
  }
}

TEST(SurfaceCharts, TheLongestEdgeIsTheHypotenuse) {
  const auto charts = charts_of(mesh_of({{0, 0, 0}, {5, 0, 0}, {1, 2, 0}}, {{0, 1, 2}}));
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].first.corners, (std::array<std::uint8_t, 3>{2, 1, 0}));
  EXPECT_NEAR(charts[0].u_length, std::sqrt(20.0), 1e-6);
  EXPECT_NEAR(charts[0].v_length, std::sqrt(5.0), 1e-6);
}

TEST(SurfaceCharts, TrianglesWithoutAreaAreInNone) {
  const float nan = std::nanf("");
  EXPECT_TRUE(
      charts_of(mesh_of({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {{0, 1, 2}, {1, 1, 2}, {0, 0, 0}})).empty());
  EXPECT_TRUE(charts_of(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, {{0, 1, 2}})).empty());
  EXPECT_EQ(charts_of(mesh_of({{0, 0, 0}, {1e-20f, 0, 0}, {0, 1e-20f, 0}}, {{0, 1, 2}})).size(), 1u);
}

}  // namespace
}  // namespace lightbench
