#include "scene/triangulate.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lightbench {
namespace {

using Polygon = std::vector<glm::vec3>;

std::vector<glm::uvec3> cut(const Polygon& polygon) {
  std::vector<glm::uvec3> triangles;
  ClippingBudget budget;
  triangulate(polygon, triangles, budget);
  return triangles;
}

// The part of a triangle's area that looks along +z; negative where it is turned over.
float area_z(const Polygon& p, const glm::uvec3& t) {
  return 0.5f * glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]).z;
}

float sum_of_areas(const Polygon& p) {
  float sum = 0;
  for (const glm::uvec3& t : cut(p)) {
    EXPECT_GE(area_z(p, t), 0.0f);
    sum += area_z(p, t);
  }
  return sum;
}

TEST(Triangulate, LeavesATriangleAsItIs) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (std::vector<glm::uvec3>{{0, 1, 2}}));
}

TEST(Triangulate, MakesAFanOfAConvexPolygon) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
            (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulate, CutsAnArrowheadAtItsInnerCorner) {
  for (std::size_t turn = 0; turn < 4; ++turn) {
    Polygon arrow{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5f, 1, 0}};
    std::rotate(arrow.begin(), arrow.begin() + std::ptrdiff_t(turn), arrow.end());
    EXPECT_FLOAT_EQ(sum_of_areas(arrow), 1.5f) << turn;
  }
}

TEST(Triangulate, CutsACombWithoutOverlaps) {
  const Polygon comb{{0, 0, 0}, {5, 0, 0}, {5, 4, 0}, {4, 4, 0}, {4, 1, 0}, {3, 1, 0},
                     {3, 4, 0}, {2, 4, 0}, {2, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};
  EXPECT_EQ(cut(comb).size(), 10u);
  EXPECT_FLOAT_EQ(sum_of_areas(comb), 14.0f);
}

TEST(Triangulate, KeepsTheSenseOfRotation) {
  Polygon arrow{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5f, 1, 0}};
  std::reverse(arrow.begin(), arrow.end());
  for (const glm::uvec3& t : cut(arrow)) EXPECT_LT(area_z(arrow, t), 0.0f);
}

TEST(Triangulate, WorksInAnyPlane) {
  const Polygon arrow{{0, 0, 0}, {0, 2, 1}, {0, 0, 2}, {0, 0.5f, 1}};
  float area = 0;
  for (const glm::uvec3& t : cut(arrow))
    area += 0.5f * glm::cross(arrow[t.y] - arrow[t.x], arrow[t.z] - arrow[t.x]).x;
  EXPECT_FLOAT_EQ(area, 1.5f);
}

TEST(Triangulate, EndsOnPolygonsThatAreBroken) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2u);
  EXPECT_EQ(cut({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).size(), 3u);
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}}).size(), 2u);
  EXPECT_EQ(cut(Polygon(10000, glm::vec3(1))).size(), 9998u);
}

// Areas of polygons that touch themselves, from whichever corner on and whichever way round.
void expect_area(Polygon polygon, float area) {
  for (std::size_t turn = 0; turn < polygon.size(); ++turn) {
    for (const bool reversed : {false, true}) {
      float sum = 0;
      for (const glm::uvec3& t : cut(polygon)) sum += std::abs(area_z(polygon, t));
      EXPECT_FLOAT_EQ(sum, area) << "from corner " << turn << (reversed ? ", reversed" : "");
      EXPECT_EQ(cut(polygon).size(), polygon.size() - 2);
      std::reverse(polygon.begin(), polygon.end());
    }
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
}

TEST(Triangulate, CoversPartsThatMeetInACorner) {
  expect_area({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}}, 2);
}

TEST(Triangulate, CoversPartsThatAreGoneAroundInOppositeWays) {
  expect_area({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}}, 2);
  expect_area({{0, 0, 0}, {1, 1, 0}, {4, 4, 0}, {4, -2, 0}, {1, 1, 0}, {0, 2, 0}}, 10);
}

TEST(Triangulate, LeavesOutHolesThatABridgeLeadsTo) {
  expect_area({{0, 0, 0},
               {4, 0, 0},
               {4, 4, 0},
               {0, 4, 0},
               {0, 0, 0},
               {1, 1, 0},
               {1, 3, 0},
               {3, 3, 0},
               {3, 1, 0},
               {1, 1, 0}},
              12);
}

TEST(Triangulate, LeavesOutHolesThatTouchTheOutline) {
  expect_area({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 2, 0}, {2, 1, 0}}, 14.5f);
  expect_area({{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {3, 2, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, 14);
}

TEST(Triangulate, CoversNothingBetweenEdgesThatLieOnOneAnother) {
  // Two blocks that a path of no width joins around a bend.
  expect_area({{0, 0, 0},
               {1, 0, 0},
               {1, 1, 0},
               {3, 3, 0},
               {5, 1, 0},
               {6, 1, 0},
               {6, 0, 0},
               {7, 0, 0},
               {7, 2, 0},
               {6, 2, 0},
               {6, 1, 0},
               {5, 1, 0},
               {3, 3, 0},
               {1, 1, 0},
               {0, 1, 0}},
              3);
}

TEST(Triangulate, CoversWhatTouchesItselfAlongAnEdge) {
  expect_area({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {0, 4, 0}}, 8);
  expect_area({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}}, 4);
  expect_area({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 1);
}

TEST(Triangulate, CoversPolygonsWithRepeatedAndCollinearCorners) {
  expect_area({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 2, 0}, {1, 1, 0}, {1, 1, 0}, {0, 2, 0}}, 3);
  expect_area({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}, {0, 1, 0}}, 3);
}

TEST(Triangulate, TellsWhereEdgesCross) {
  std::vector<glm::uvec3> triangles;
  ClippingBudget budget;
  EXPECT_TRUE(triangulate(Polygon{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5f, 1, 0}}, triangles, budget));
  Polygon pentagram;
  for (int i = 0; i < 5; ++i)
    pentagram.emplace_back(std::cos(2.513274f * float(i)), std::sin(2.513274f * float(i)), 0);
  EXPECT_FALSE(triangulate(pentagram, triangles, budget));
}

TEST(Triangulate, WithoutABudgetGivesAFanAndSaysSo) {
  const Polygon arrow{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5f, 1, 0}};
  std::vector<glm::uvec3> triangles;
  ClippingBudget budget{0, 0};
  EXPECT_FALSE(triangulate(arrow, triangles, budget));
  EXPECT_EQ(triangles.size(), 2u);
}

// A comb of many teeth: clipping its ears one by one, each tested against all corners, would take minutes.
TEST(Triangulate, CutsTenThousandCornersInTime) {
  constexpr int kTeeth = 2500;
  Polygon comb{{0, 0, 0}, {2 * kTeeth - 1, 0, 0}};
  for (int i = kTeeth - 1; i >= 0; --i) {
    comb.emplace_back(2 * i + 1, 4, 0);
    comb.emplace_back(2 * i, 4, 0);
    if (i > 0) comb.emplace_back(2 * i, 1, 0);
    if (i > 0) comb.emplace_back(2 * i - 1, 1, 0);
  }
  ASSERT_EQ(comb.size(), 10'000u);
  double sum = 0;
  for (const glm::uvec3& t : cut(comb)) sum += double(area_z(comb, t));
  EXPECT_DOUBLE_EQ(sum, 4 * kTeeth + kTeeth - 1);
}

RC_GTEST_PROP(Triangulate, CoversAStarExactly, (const std::vector<unsigned>& lengths)) {
  RC_PRE(lengths.size() >= 4 && lengths.size() < 60);
  Polygon star;
  float area = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const float angle = 6.2831853f * float(i) / float(lengths.size());
    const float length = 1.0f + float(lengths[i] % 100) / 25.0f;
    star.emplace_back(length * std::cos(angle), length * std::sin(angle), 0);
  }
  for (std::size_t i = 0; i < star.size(); ++i)
    area += 0.5f * glm::cross(star[i], star[(i + 1) % star.size()]).z;
  float sum = 0;
  for (const glm::uvec3& t : cut(star)) sum += std::abs(area_z(star, t));
  RC_ASSERT(cut(star).size() == star.size() - 2);
  // Rounding of the sum of up to 58 floats.
  RC_ASSERT(std::abs(sum - area) < 1e-4f * area);
}

}  // namespace
}  // namespace lightbench
