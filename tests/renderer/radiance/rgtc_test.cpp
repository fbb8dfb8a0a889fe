#include "renderer/radiance/rgtc.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lightbench {
namespace {

constexpr std::uint32_t kAll = 0xffff;

TEST(Rgtc, DecodesAsOpenGlSays) {
  // Ends 240 and 30; the first five texels have the codes 0, 1, 2, 4 and 7.
  const std::uint64_t codes = 0 | 1 << 3 | 2 << 6 | 4 << 9 | 7 << 12;
  const std::uint64_t block = 240 | 30 << 8 | codes << 16;
  EXPECT_EQ(decode_rgtc(block, 0), 240);
  EXPECT_EQ(decode_rgtc(block, 1), 30);
  EXPECT_EQ(decode_rgtc(block, 2), 210);  // (6 * 240 + 30) / 7
  EXPECT_EQ(decode_rgtc(block, 3), 150);  // (4 * 240 + 3 * 30) / 7
  EXPECT_EQ(decode_rgtc(block, 4), 60);   // (240 + 6 * 30) / 7
}

TEST(Rgtc, KeepsTwoNumbersExactly) {
  std::array<float, 16> numbers;
  for (std::size_t i = 0; i < 16; ++i) numbers[i] = i % 3 == 0 ? 17 : 201;
  const std::uint64_t block = encode_rgtc(numbers, kAll);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(decode_rgtc(block, i), numbers[std::size_t(i)]);
}

TEST(Rgtc, KeepsOneNumberExactly) {
  std::array<float, 16> numbers;
  numbers.fill(255);
  EXPECT_EQ(decode_rgtc(encode_rgtc(numbers, kAll), 9), 255);
}

TEST(Rgtc, DoesNotMindNumbersThatDoNotCount) {
  std::array<float, 16> numbers;
  for (std::size_t i = 0; i < 16; ++i) numbers[i] = i < 8 ? 100 + float(i) : 255 * float(i % 2);
  const std::uint64_t block = encode_rgtc(numbers, 0x00ff);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(decode_rgtc(block, i), numbers[std::size_t(i)]);
}

RC_GTEST_PROP(Rgtc, NoSumOfErrorsIsWorseThanSevenEqualSteps, ()) {
  std::array<float, 16> numbers;
  for (float& number : numbers) number = float(*rc::gen::inRange(0, 256));
  const auto [least, most] = std::ranges::minmax(numbers);
  const std::uint64_t block = encode_rgtc(numbers, kAll);
  double squares = 0;
  for (int i = 0; i < 16; ++i) squares += std::pow(float(decode_rgtc(block, i)) - numbers[std::size_t(i)], 2);
  // Half a step, and half for rounding between the ends.
  RC_ASSERT(squares <= 16 * std::pow((most - least) / 14 + 0.5, 2) + 1e-3);
}

}  // namespace
}  // namespace lightbench
