#include "renderer/radiance/direction_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lightbench {
namespace {

constexpr float kRounding = 2e-6f;  // of a few products of floats about 1

TEST(DirectionGrid, EachOrderVisitsEveryDirectionOnce) {
  for (const LayerOrderName& row : layer_orders()) {
    const DirectionGrid grid{5, 6, row.order};
    std::vector<int> layers;
    for (int i = 0; i < grid.thetas; ++i)
      for (int j = 0; j < grid.phis; ++j) {
        layers.push_back(grid.layer(i, j));
        EXPECT_EQ(grid.place(grid.layer(i, j)), glm::ivec2(i, j)) << row.name;
      }
    std::ranges::sort(layers);
    for (int k = 0; k < grid.layers(); ++k) EXPECT_EQ(layers[std::size_t(k)], k) << row.name;
  }
}

TEST(DirectionGrid, OrdersAreThoseOfTheirEquations) {
  EXPECT_EQ((DirectionGrid{20, 20, LayerOrder::theta_major}.layer(3, 7)), 3 * 20 + 7);
  EXPECT_EQ((DirectionGrid{20, 20, LayerOrder::phi_major}.layer(3, 7)), 7 * 20 + 3);
  EXPECT_EQ((DirectionGrid{20, 20, LayerOrder::phi_serpentine}.layer(3, 6)), 6 * 20 + 3);
  EXPECT_EQ((DirectionGrid{20, 20, LayerOrder::phi_serpentine}.layer(3, 7)), 7 * 20 + 16);
}

TEST(DirectionGrid, NeighboursInTheSerpentineAreNeighboursOnTheHemisphere) {
  const DirectionGrid grid{20, 20, LayerOrder::phi_serpentine};
  for (int k = 1; k < grid.layers(); ++k) {
    const glm::ivec2 step = grid.place(k) - grid.place(k - 1);
    EXPECT_EQ(std::abs(step.x) + std::abs(step.y), 1) << k;
  }
}

TEST(DirectionGrid, RunsFromTheNormalToTheHorizon) {
  const DirectionGrid grid{20, 20};
  EXPECT_NEAR(glm::distance(grid.direction(0, 5), {0, 1, 0}), 0, kRounding);
  EXPECT_NEAR(glm::distance(grid.direction(19, 0), {1, 0, 0}), 0, kRounding);
  EXPECT_NEAR(glm::distance(grid.direction(19, 5), {0, 0, 1}), 0, kRounding);
}

TEST(NearestDirections, OfADirectionOfTheGridIsThatDirection) {
  const DirectionGrid grid{7, 9};
  for (int i = 1; i < grid.thetas; ++i)
    for (int j = 0; j < grid.phis; ++j) {
      const NearestDirections found = nearest_directions(grid, 3.0f * grid.direction(i, j));
      const int theta = found.theta_part < 0.5f ? found.theta[0] : found.theta[1];
      const int phi = found.phi_part < 0.5f ? found.phi[0] : found.phi[1];
      EXPECT_EQ(theta, i);
      EXPECT_EQ(phi, j);
      EXPECT_NEAR(std::abs(found.theta_part - 0.5f), 0.5f, 1e-5f);
      EXPECT_NEAR(std::abs(found.phi_part - 0.5f), 0.5f, 1e-5f);
    }
}

TEST(NearestDirections, PhiWrapsAround) {
  const DirectionGrid grid{3, 4};
  const float phi = 315 * std::numbers::pi_v<float> / 180;
  const NearestDirections found = nearest_directions(grid, {std::cos(phi), 1, std::sin(phi)});
  EXPECT_EQ(found.phi, glm::ivec2(3, 0));
  EXPECT_NEAR(found.phi_part, 0.5f, 1e-5f);
}

TEST(NearestDirections, BelowTheHorizonTheHorizonCounts) {
  const NearestDirections found = nearest_directions({20, 20}, {1, -0.3f, 0});
  EXPECT_EQ(found.theta, glm::ivec2(19, 19));
}

RC_GTEST_PROP(NearestDirections, AreAroundAnyDirection, ()) {
  const auto coordinate = [] { return float(*rc::gen::inRange(-1000, 1001)) / 1000; };
  const DirectionGrid grid{*rc::gen::inRange(2, 30), *rc::gen::inRange(1, 30)};
  const glm::vec3 local{coordinate(), coordinate(), coordinate()};
  RC_PRE(glm::length(local) > 0);
  const NearestDirections found = nearest_directions(grid, local);
  for (int i = 0; i < 2; ++i) {
    RC_ASSERT(found.theta[i] >= 0 && found.theta[i] < grid.thetas);
    RC_ASSERT(found.phi[i] >= 0 && found.phi[i] < grid.phis);
  }
  RC_ASSERT(found.theta_part >= 0 && found.theta_part <= 1 && found.phi_part >= 0 && found.phi_part <= 1);
}

void expect_frame(const glm::vec3& normal) {
  const glm::mat3 frame = frame_of_normal(normal);
  EXPECT_NEAR(glm::distance(frame * glm::vec3(0, 1, 0), normal), 0, kRounding);
  EXPECT_NEAR(glm::determinant(frame), 1, 1e-5f);
  const glm::mat3 product = frame * glm::transpose(frame);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], i == j ? 1 : 0, 1e-3f);
}

TEST(FrameOfNormal, IsARotationThatTakesUpToTheNormal) {
  expect_frame({0, 1, 0});
  expect_frame({1, 0, 0});
  expect_frame({0, -1, 0});
  expect_frame(glm::normalize(glm::vec3(0.3f, -0.8f, 0.5f)));
  expect_frame(glm::normalize(glm::vec3(0.01f, -1, 0.02f)));
}

TEST(FrameOfNormal, TurnsNoMoreThanItMust) {
  // What is perpendicular to both stays.
  const glm::vec3 axis = frame_of_normal({1, 0, 0}) * glm::vec3(0, 0, 1);
  EXPECT_NEAR(glm::distance(axis, {0, 0, 1}), 0, kRounding);
}

}  // namespace
}  // namespace lightbench
