#include "renderer/radiance/piecewise.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "renderer/radiance/piecewise_encoder.h"
#include "renderer/radiance/ramp.h"
#include "tests/renderer/radiance/random_stacks.h"

namespace lightbench {
namespace {

using ::testing::ElementsAre;

std::vector<int> reds(const ByteStack& stack, std::size_t texel) {
  std::vector<int> values;
  for (std::size_t i = texel; i < stack.texels.size(); i += stack.layer_size())
    values.push_back(stack.texels[i][0]);
  return values;
}

TEST(Piecewise, LinesAreRoundedToNearestAndHalvesUp) {
  EXPECT_EQ(interpolate(10, 20, 0, 4), 10);
  EXPECT_EQ(interpolate(10, 20, 1, 4), 13);  // 12.5
  EXPECT_EQ(interpolate(20, 10, 1, 4), 18);  // 17.5
  EXPECT_EQ(interpolate(10, 20, 1, 3), 13);  // 13.3
  EXPECT_EQ(interpolate(10, 20, 2, 3), 17);  // 16.7
  EXPECT_EQ(interpolate(10, 20, 4, 4), 20);
  EXPECT_EQ(interpolate(255, 255, 32768, 65535), 255);
}

TEST(Piecewise, SamplesAreJoinedByLinesAndTheLastOneStays) {
  // Two texels of six layers: kept at 0, 2, 4 and at 0.
  const PiecewiseStack stack{
      2, 1, {3, 2}, 1, {0, 3}, {0, 2, 4, 0}, {1, 0, 2, 1}, {{0, 0, 0}, {8, 0, 0}, {100, 0, 0}}};
  const ByteStack decoded = decode_piecewise(stack);
  EXPECT_THAT(reds(decoded, 0), ElementsAre(8, 4, 0, 50, 100, 100));
  EXPECT_THAT(reds(decoded, 1), ElementsAre(8, 8, 8, 8, 8, 8));
  EXPECT_EQ(decoded.grid, stack.grid);
}

TEST(Piecewise, WithoutIndicesSamplesHaveColorsOfTheirOwn) {
  const PiecewiseStack stack{1, 1, {3, 1}, 1, {0}, {0, 2}, {}, {{3, 0, 0}, {5, 0, 0}}};
  EXPECT_THAT(reds(decode_piecewise(stack), 0), ElementsAre(3, 4, 5));
}

RC_GTEST_PROP(Piecewise, OneValueIsWhatTheWholeObjectHasThere, ()) {
  const PiecewiseStack stack = encode_piecewise(any_stack(), SampleRule::greedy, *rc::gen::element(0, 6, 30));
  const ByteStack decoded = decode_piecewise(stack);
  for (int layer = 0; layer < stack.grid.layers(); ++layer)
    for (std::size_t texel = 0; texel < stack.texels(); ++texel)
      RC_ASSERT(decode_piecewise(stack, texel, layer) ==
                decoded.texels[std::size_t(layer) * decoded.layer_size() + texel]);
}

RC_GTEST_PROP(Ramp, IsTheFormulaStepByStep, (Rgb8 a, Rgb8 b)) {
  const int length = *rc::gen::oneOf(rc::gen::inRange(1, 600), rc::gen::inRange(1, 65536));
  Ramp ramp(a, b, length);
  for (int at = 0; at <= length; ++at, ramp.step())
    for (std::size_t c = 0; c < 3; ++c) RC_ASSERT(ramp.component(c) == interpolate(a[c], b[c], at, length));
}

}  // namespace
}  // namespace lightbench
