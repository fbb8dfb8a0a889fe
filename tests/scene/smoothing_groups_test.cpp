#include "scene/smoothing_groups.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

// Two walls that meet at a right angle in the edge 0-1, one of them cut into two triangles there.
const std::vector<glm::vec3> kPoints{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 1}, {0, 0, 1}};
const std::vector<glm::uvec3> kTriangles{{0, 3, 2}, {0, 2, 1}, {0, 1, 4}, {0, 4, 5}};

std::vector<glm::vec3> normals(const std::vector<std::int32_t>& groups) {
  return smoothing_group_normals(kPoints, kTriangles, groups, std::vector<bool>(12, true));
}

TEST(SmoothingGroups, AreSmoothOverSharpEdges) {
  const auto n = normals({1, 1, 1, 1});
  const glm::vec3 mean = glm::normalize(glm::vec3(1, 0, 1));
  // Rounding of a normalised vector of floats; each wall counts with its angle, however it is cut.
  EXPECT_LT(glm::length(n[0] - mean), 1e-6f);
  EXPECT_LT(glm::length(n[5] - mean), 1e-6f);
  EXPECT_EQ(n[0], n[6]);
  EXPECT_EQ(n[1], glm::vec3(0, 0, 1)) << "away from the edge";
}

TEST(SmoothingGroups, EndAtOtherGroups) {
  const auto n = normals({1, 1, 2, 2});
  EXPECT_EQ(n[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(n[6], glm::vec3(1, 0, 0));
}

TEST(SmoothingGroups, NumberZeroIsFlat) {
  const auto n = normals({0, 1, 1, 0});
  EXPECT_EQ(n[0], glm::vec3(0, 0, 1));
  EXPECT_GT(n[3].x, 0.1f);
  EXPECT_EQ(n[9], glm::vec3(1, 0, 0));
}

TEST(SmoothingGroups, OfFacesThatLookToOppositeSidesAreFlat) {
  const std::vector<glm::uvec3> both{{0, 3, 2}, {0, 2, 3}};
  const std::vector<std::int32_t> groups{1, 1};
  const auto n = smoothing_group_normals(kPoints, both, groups, std::vector<bool>(6, true));
  EXPECT_EQ(n[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(n[3], glm::vec3(0, 0, -1));
}

TEST(SmoothingGroups, AreComputedWhereWantedOnly) {
  std::vector<bool> wanted(12, false);
  wanted[1] = true;
  const std::vector<std::int32_t> groups{1, 1, 1, 1};
  const auto n = smoothing_group_normals(kPoints, kTriangles, groups, wanted);
  EXPECT_EQ(n[0], glm::vec3(0));
  EXPECT_EQ(n[1], glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace lightbench
