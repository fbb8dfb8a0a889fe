#include "renderer/techniques/isr_kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

TEST(IsrKernel, SharesOfASpiralAddUpToItsDisc) {
  for (const float spread : {0.5f, 1.0f, 1.5f}) {
    double sum = 0;
    for (const KernelSample& sample : spiral_kernel(48, 100, spread)) sum += sample.area;
    EXPECT_NEAR(sum, std::numbers::pi * 100 * 100, 1) << "float rounding of 48 shares";
  }
}

TEST(IsrKernel, ASpiralOfSpreadOneHalfIsUniform) {
  const auto kernel = spiral_kernel(24, 50, 0.5f);
  for (const KernelSample& sample : kernel) EXPECT_NEAR(sample.area, kernel[0].area, 1e-2f);
}

TEST(IsrKernel, SamplesLieInsideTheRingThatTheyStandFor) {
  const auto kernel = spiral_kernel(80, 100, 1.5f);
  double inside = 0;
  for (const KernelSample& sample : kernel) {
    const double r = glm::length(sample.offset);
    const double disc = std::numbers::pi * r * r;
    EXPECT_GT(disc, inside);
    inside += sample.area;
    EXPECT_LT(disc, inside);
  }
}

TEST(IsrKernel, JitteredSamplesLieAnywhereInTheirRings) {
  const auto spiral = spiral_kernel(48, 100, 1.5f);
  const auto jittered = jittered_kernel(48, 100, 1.5f);
  double inside = 0;
  for (std::size_t i = 0; i < jittered.size(); ++i) {
    EXPECT_EQ(jittered[i].area, spiral[i].area);
    const double r = glm::length(jittered[i].offset);
    const double disc = std::numbers::pi * r * r;
    EXPECT_GE(disc, inside * 0.999) << "float rounding";
    inside += jittered[i].area;
    EXPECT_LE(disc, inside * 1.001);
  }
}

TEST(IsrKernel, JitteredSamplesLieInSectorsOfTheirOwn) {
  std::set<int> sectors;
  for (const KernelSample& sample : jittered_kernel(48, 100, 1.5f)) {
    const double turn = std::atan2(sample.offset.y, sample.offset.x) / (2 * std::numbers::pi);
    sectors.insert(int(std::floor((turn < 0 ? turn + 1 : turn) * 48)));
  }
  EXPECT_EQ(sectors.size(), 48u);
}

TEST(IsrKernel, AGreaterSpreadCrowdsSamplesAtTheCentre) {
  EXPECT_LT(glm::length(spiral_kernel(48, 100, 1.5f)[24].offset),
            glm::length(spiral_kernel(48, 100, 0.5f)[24].offset));
}

TEST(IsrKernel, AGridIsTheSquareWithoutItsCentre) {
  std::set<std::pair<float, float>> cells;
  for (const KernelSample& sample : grid_kernel(48, 2.0f)) {
    cells.emplace(sample.offset.x, sample.offset.y);
    EXPECT_EQ(sample.area, 4.0f);
    EXPECT_LE(std::max(std::abs(sample.offset.x), std::abs(sample.offset.y)), 6.0f);
  }
  EXPECT_EQ(cells.size(), 48u);
  EXPECT_FALSE(cells.contains({0.0f, 0.0f}));
}

TEST(IsrKernel, KnowsTheCountsThatFillAGrid) {
  for (const int count : {8, 24, 48, 80, 120}) EXPECT_TRUE(fills_grid(count)) << count;
  for (const int count : {1, 3, 15, 47, 49}) EXPECT_FALSE(fills_grid(count)) << count;
}

TEST(IsrKernel, SamplesThatStandForManyBlocksReadBlocks) {
  const auto kernel = spiral_kernel(48, 512, 1.5f);
  const int near = near_samples(kernel, 4);
  EXPECT_LT(kernel[std::size_t(near) - 1].area, 16 * 16);
  EXPECT_GE(kernel[std::size_t(near)].area, 16 * 16);
  EXPECT_EQ(near_samples(kernel, 1), 48);
  EXPECT_EQ(near_samples(grid_kernel(48, 1), 4), 48);
}

TEST(IsrKernel, ReachesToItsLastSample) {
  EXPECT_FLOAT_EQ(kernel_reach(grid_kernel(48, 1)), 3 * std::sqrt(2.0f));
}

}  // namespace
}  // namespace lightbench
