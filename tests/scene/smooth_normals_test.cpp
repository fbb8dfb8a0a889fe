#include "scene/smooth_normals.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using Points = std::vector<glm::vec3>;
using Triangles = std::vector<glm::uvec3>;

std::vector<glm::vec3> all_normals(const Points& points, const Triangles& triangles, float crease_degrees) {
  return smooth_normals(points, triangles, glm::radians(crease_degrees),
                        std::vector<bool>(3 * triangles.size(), true));
}

// Two triangles that meet at the edge 0-1 (the y axis): one lies in z = 0 with the area `left`, the other one
// is bent back by an angle, with the area 1/2.
Points roof(float degrees, float left) {
  const float a = glm::radians(degrees);
  return {{0, 0, 0}, {0, 1, 0}, {-2 * left, 0, 0}, {std::cos(a), 0, -std::sin(a)}};
}
const Triangles kRoof{{0, 1, 2}, {0, 3, 1}};

TEST(SmoothNormals, AreFlatAcrossACrease) {
  const auto normals = all_normals(roof(60, 0.5f), kRoof, 40);
  for (int corner = 0; corner < 3; ++corner) EXPECT_EQ(normals[std::size_t(corner)], normals[0]);
  EXPECT_EQ(normals[0], glm::vec3(0, 0, 1));
  EXPECT_NEAR(normals[3].x, std::sin(glm::radians(60.0f)), 1e-6f);
}

TEST(SmoothNormals, AreTheMeanBelowTheCreaseAngle) {
  const auto normals = all_normals(roof(30, 0.5f), kRoof, 40);
  const glm::vec3 mean(std::sin(glm::radians(15.0f)), 0, std::cos(glm::radians(15.0f)));
  EXPECT_LT(glm::length(normals[0] - mean), 1e-6f);
  EXPECT_EQ(normals[0], normals[3]);
  EXPECT_EQ(normals[2], glm::vec3(0, 0, 1)) << "the far corner belongs to one triangle only";
}

TEST(SmoothNormals, AreWeightedWithArea) {
  const auto normals = all_normals(roof(30, 1.5f), kRoof, 40);
  const float a = glm::radians(30.0f);
  const glm::vec3 mean = glm::normalize(3.0f * glm::vec3(0, 0, 1) + glm::vec3(std::sin(a), 0, std::cos(a)));
  EXPECT_LT(glm::length(normals[0] - mean), 1e-6f);
}

TEST(SmoothNormals, IncludeFacesAtExactlyTheCreaseAngle) {
  const auto normals = all_normals(roof(40, 0.5f), kRoof, 40);
  EXPECT_EQ(normals[0], normals[3]);
}

TEST(SmoothNormals, AreComputedWhereWantedOnly) {
  std::vector<bool> wanted(6, false);
  wanted[1] = true;
  const auto normals = smooth_normals(roof(30, 0.5f), kRoof, 1.0f, wanted);
  EXPECT_EQ(normals[0], glm::vec3(0));
  EXPECT_NEAR(glm::length(normals[1]), 1.0f, 1e-6f);
}

TEST(SmoothNormals, OfASphereAreItsDirections) {
  constexpr unsigned kColumns = 32;
  constexpr unsigned kRows = 16;
  Points points{{0, 1, 0}};
  for (unsigned row = 1; row < kRows; ++row)
    for (unsigned column = 0; column < kColumns; ++column) {
      const float phi = 6.2831853f * float(column) / kColumns;
      const float theta = 3.14159265f * float(row) / kRows;
      points.emplace_back(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
    }
  Triangles triangles;
  const auto at = [&](unsigned row, unsigned column) { return 1 + (row - 1) * kColumns + column % kColumns; };
  for (unsigned column = 0; column < kColumns; ++column) {
    triangles.emplace_back(0u, at(1, column), at(1, column + 1));
    for (unsigned row = 1; row + 1 < kRows; ++row) {
      triangles.emplace_back(at(row, column), at(row + 1, column), at(row + 1, column + 1));
      triangles.emplace_back(at(row, column), at(row + 1, column + 1), at(row, column + 1));
    }
  }
  const auto normals = all_normals(points, triangles, 40);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const unsigned point = triangles[i].x;
    if (point >= at(kRows - 2, 0)) continue;
    // The faces span 11 degrees; their mean is within 3 degrees of the sphere's direction.
    EXPECT_GT(glm::dot(normals[3 * i], points[point]), std::cos(glm::radians(3.0f)));
  }
}

TEST(SmoothNormals, OfASpikeWithTooManyFacesAreFlat) {
  Points points{{0, 0, 0}};
  Triangles triangles;
  for (unsigned i = 0; i < 3000; ++i) {
    points.emplace_back(float(i), 1, 0);
    if (i > 0) triangles.emplace_back(0u, i + 1, i);
  }
  EXPECT_EQ(all_normals(points, triangles, 40)[0], glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace lightbench
