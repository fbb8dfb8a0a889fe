#include "renderer/paths/sobol.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/paths/lanes.h"

namespace lightbench {
namespace {

/// The point before any scrambling.
SobolPair<std::uint32_t> plain_point(std::uint32_t index) {
  return {reverse_bits(index), reverse_bits(sobol_second_reversed(index))};
}

TEST(Sobol, StartsWithTheKnownPoints) {
  // Joe and Kuo's first two dimensions, without Gray code.
  const std::vector<std::pair<float, float>> expected{{0, 0},           {0.5f, 0.5f},     {0.25f, 0.75f},
                                                      {0.75f, 0.25f},   {0.125f, 0.625f}, {0.625f, 0.125f},
                                                      {0.375f, 0.375f}, {0.875f, 0.875f}};
  for (std::uint32_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(unit_float(plain_point(i).x), expected[i].first) << i;
    EXPECT_EQ(unit_float(plain_point(i).y), expected[i].second) << i;
  }
}

/// Whether each of the boxes of 2^-a by 2^-(m - a) has exactly one of 2^m points, for all a: a (0,m,2)-net.
bool is_net(const std::vector<SobolPair<std::uint32_t>>& points, unsigned m) {
  for (unsigned a = 0; a <= m; ++a) {
    std::set<std::uint64_t> boxes;
    for (const auto& p : points)
      boxes.insert((std::uint64_t(p.x) >> (32 - a)) << m | std::uint64_t(p.y) >> (32 - (m - a)));
    if (boxes.size() != points.size()) return false;
  }
  return true;
}

TEST(Sobol, ScrambledPointsFormNets) {
  for (const std::uint32_t seed : {0u, 1u, 0xdeadbeefu})
    for (unsigned m = 0; m <= 10; ++m) {
      std::vector<SobolPair<std::uint32_t>> points;
      for (std::uint32_t i = 0; i < 1u << m; ++i) points.push_back(sobol_pair(i, seed));
      EXPECT_TRUE(is_net(points, m)) << "seed " << seed << ", m " << m;
    }
}

TEST(Sobol, EveryAlignedBlockIsANet) {
  std::vector<SobolPair<std::uint32_t>> points;
  for (std::uint32_t i = 192; i < 256; ++i) points.push_back(sobol_pair(i, 7u));
  EXPECT_TRUE(is_net(points, 6)) << "so that doubling the samples keeps the strata";
}

TEST(Sobol, SeedsGiveOtherPoints) {
  int equal = 0;
  for (std::uint32_t i = 0; i < 256; ++i) equal += sobol_pair(i, 1u).x >> 16 == sobol_pair(i, 2u).x >> 16;
  EXPECT_LE(equal, 2) << "of 256 pairs that agree in 16 bits by chance with a probability of 2^-16 each";
}

TEST(Sobol, ScrambledPointsAreUniformOverSeeds) {
  double mean = 0, product = 0;
  constexpr int kSeeds = 20000;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const auto p = sobol_pair(3u, seed);
    mean += double(unit_float(p.x)) / kSeeds;
    product += double(unit_float(p.x)) * double(unit_float(p.y)) / kSeeds;
  }
  EXPECT_NEAR(mean, 0.5, 0.01) << "five standard errors of 0.29 / sqrt(20000)";
  EXPECT_NEAR(product, 0.25, 0.01);
}

TEST(Sobol, VectorsGiveWhatSinglesGive) {
  const auto eight = sobol_pair(lane_numbers() * 77u, lane_numbers() + 5u);
  for (std::uint32_t i = 0; i < 8; ++i) {
    const auto one = sobol_pair(i * 77u, i + 5u);
    EXPECT_EQ(eight.x[i], one.x);
    EXPECT_EQ(eight.y[i], one.y);
  }
}

}  // namespace
}  // namespace lightbench
