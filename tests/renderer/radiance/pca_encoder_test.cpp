#include "renderer/radiance/pca_encoder.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/renderer/radiance/pca_stacks.h"

namespace lightbench {
namespace {

using namespace test;

/// For each value in turn the sum over components of |decoded - true|.
std::vector<int> sums_of_errors(const HalfStack& stack, const PcaStack& pca) {
  const ByteStack truth = to_bytes(stack), decoded = decode_pca(pca);
  std::vector<int> sums;
  for (std::size_t i = 0; i < truth.texels.size(); ++i) {
    sums.push_back(0);
    for (std::size_t c = 0; c < 3; ++c) sums.back() += std::abs(truth.texels[i][c] - decoded.texels[i][c]);
  }
  return sums;
}

double mean_changed(const std::vector<int>& sums) {
  double sum = 0;
  for (const int s : sums) sum += s;
  const auto same = std::ranges::count(sums, 0);
  return sum / 3 / double(std::ptrdiff_t(sums.size()) - same);
}

double error_99(std::vector<int> sums) {
  std::ranges::sort(sums);
  return sums[(99 * sums.size() + 99) / 100 - 1] / 3.0;
}

std::size_t raw_bytes(const HalfStack& stack) {
  return 3 * stack.texels.size();
}

TEST(PcaEncoder, KeepsWhatIsMatteExactlyAndInFourBytesATexel) {
  const HalfStack stack = half_stack(24, 17, {20, 20}, [](int x, int y, const glm::vec3&) {
    return glm::vec3(0.003f * float(x * y % 391), 0.04f * float(x), 0.05f * float(y));
  });
  const PcaStack pca = encode_pca(stack, {}, {});
  EXPECT_EQ(std::ranges::max(sums_of_errors(stack, pca)), 0);
  EXPECT_LT(pca.bytes(), 4 * pca.texels() + 100);
}

TEST(PcaEncoder, ReachesTheErrorsThatAreWanted) {
  const HalfStack stack = glossy_stack(40, 32, {12, 12}, 0.5f);
  PcaOptions options;
  for (const auto& [mean, most] : {std::pair(2.0, 9.0), std::pair(1.1, 6.0), std::pair(0.9, 2.0)}) {
    options.mean_error = mean, options.error_99 = most;
    const std::vector<int> sums = sums_of_errors(stack, encode_pca(stack, {}, options));
    EXPECT_LE(mean_changed(sums), mean);
    EXPECT_LE(error_99(sums), most);
  }
}

TEST(PcaEncoder, TakesNoMoreCoefficientsThanTheErrorsNeed) {
  const HalfStack stack = glossy_stack(40, 32, {12, 12}, 0.5f);
  PcaOptions options;
  const PcaStack pca = encode_pca(stack, {}, options);
  ASSERT_GT(pca.coefficients(), 4u);
  options.max_coefficients = int(pca.coefficients()) - 2;
  const std::vector<int> sums = sums_of_errors(stack, encode_pca(stack, {}, options));
  EXPECT_TRUE(mean_changed(sums) > options.mean_error || error_99(sums) > options.error_99);
}

TEST(PcaEncoder, DoesItsBestWhereTheLimitIsTooLow) {
  const HalfStack stack = glossy_stack(40, 32, {12, 12}, 0.5f);
  PcaOptions options;
  options.max_coefficients = 6;
  options.mean_error = 0.4;
  EXPECT_EQ(encode_pca(stack, {}, options).coefficients(), 6u);
}

TEST(PcaEncoder, LeavesOpenHowFarSaturatedValuesWouldGo) {
  // An eighth is cut off at 255. A fit that must meet that edge exactly is still above an error of 1.1 with
  // 40 coefficients.
  const HalfStack stack = glossy_stack(40, 32, {12, 12}, 2);
  const PcaStack pca = encode_pca(stack, {}, {});
  EXPECT_LE(mean_changed(sums_of_errors(stack, pca)), 1.1);
  EXPECT_LE(pca.coefficients(), 24u);
}

TEST(PcaEncoder, TexelsThatDoNotCountCostNothing) {
  HalfStack stack = glossy_stack(40, 32, {12, 12}, 0.5f);
  const PcaStack alone = encode_pca(stack, {}, {});
  std::vector<std::uint8_t> counts(stack.layer_size(), 1);
  const HalfStack noise = noise_stack(40, 32, stack.grid, 1);
  for (std::size_t i = 0; i < stack.texels.size(); ++i) {
    const std::size_t place = i % stack.layer_size();
    if (place % 40 % 20 < 10) continue;
    counts[place] = 0;
    stack.texels[i] = noise.texels[i];
  }
  const PcaStack pca = encode_pca(stack, counts, {});
  std::vector<int> sums = sums_of_errors(stack, pca), counted;
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (counts[i % stack.layer_size()]) counted.push_back(sums[i]);
  EXPECT_LE(mean_changed(counted), 1.1);
  EXPECT_LE(pca.coefficients(), alone.coefficients());
}

TEST(PcaEncoder, NothingHasToCount) {
  const HalfStack stack = noise_stack(5, 3, {3, 3}, 1);
  const std::vector<std::uint8_t> counts(15, 0);
  EXPECT_EQ(decode_pca(encode_pca(stack, counts, {})).texels.size(), stack.texels.size());
}

TEST(PcaEncoder, GivesTheFirstCoefficientsSixteenBitsOnRequest) {
  const HalfStack stack = glossy_stack(40, 32, {12, 12}, 0.5f);
  PcaOptions options;
  EXPECT_EQ(encode_pca(stack, {}, options).narrow_coefficients(), 4u);
  options.first_bits = 16;
  const PcaStack pca = encode_pca(stack, {}, options);
  EXPECT_EQ(pca.wide_coefficients(), 4u);
  EXPECT_EQ(pca.narrow_coefficients(), 0u);
}

TEST(PcaEncoder, IsTheSameEachTime) {
  const HalfStack stack = glossy_stack(40, 32, {8, 8}, 2);
  EXPECT_EQ(encode_pca(stack, {}, {}), encode_pca(stack, {}, {}));
}

TEST(PcaEncoder, CorrectionsTakeFewerBytesThanRawAtAFarSmallerError) {
  const HalfStack stack = glossy_stack(64, 64, {12, 12}, 1);
  PcaOptions options;
  options.threshold = 6;
  const PcaStack pca = encode_pca(stack, {}, options);
  EXPECT_LT(std::ranges::max(sums_of_errors(stack, pca)), 6);
  EXPECT_GT(double(raw_bytes(stack)) / double(pca.bytes()), 10);
}

RC_GTEST_PROP(PcaEncoder, KeepsAnyThresholdOfAnyStack, ()) {
  const int width = *rc::gen::inRange(1, 10), height = *rc::gen::inRange(1, 7);
  const DirectionGrid grid{*rc::gen::inRange(2, 5), *rc::gen::inRange(1, 6)};
  PcaOptions options;
  options.max_coefficients = 6;
  options.threshold = *rc::gen::element(1, 2, 3, 4, 6, 9, 50);
  const HalfStack stack = noise_stack(width, height, grid, *rc::gen::inRange(1u, 1000u));
  RC_ASSERT(std::ranges::max(sums_of_errors(stack, encode_pca(stack, {}, options))) < options.threshold);
}

}  // namespace
}  // namespace lightbench
