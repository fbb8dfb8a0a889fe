#include "scene/triangulate.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lightbench {
namespace {

using Polygon = std::vector<glm::vec3>;

std::vector<glm::uvec3> cut(const Polygon& polygon) {
  std::vector<glm::uvec3> triangles;
  triangulate(polygon, triangles);
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
