#include "renderer/radiance/piecewise_encoder.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "tests/renderer/radiance/random_stacks.h"
#include "tests/renderer/radiance/synthetic_wall.h"

namespace lightbench {
namespace {

using ::testing::ElementsAre;

/// One texel, with a direction for each value.
ByteStack texel_of(const std::vector<Rgb8>& values) {
  return {1, 1, {int(values.size()), 1}, 1, ByteStack::Texels(values.begin(), values.end())};
}
ByteStack greys(const std::vector<int>& values) {
  std::vector<Rgb8> colors;
  for (const int v : values) colors.push_back({std::uint8_t(v), std::uint8_t(v), std::uint8_t(v)});
  return texel_of(colors);
}
std::vector<std::uint16_t> kept(const ByteStack& stack, SampleRule rule, int threshold) {
  return encode_piecewise(stack, rule, threshold).layers;
}

/// Within a RapidCheck property.
std::vector<Rgb8> any_texel() {
  const ByteStack stack = any_stack();
  std::vector<Rgb8> values;
  for (std::size_t i = 0; i < stack.texels.size(); i += stack.layer_size()) values.push_back(stack.texels[i]);
  return values;
}

/// The largest sum over the components of |decoded - true|.
int max_error(const ByteStack& a, const ByteStack& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.texels.size(); ++i) {
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += std::abs(a.texels[i][c] - b.texels[i][c]);
    largest = std::max(largest, sum);
  }
  return largest;
}

TEST(GreedyRule, KeepsOneSampleOfAConstant) {
  EXPECT_THAT(kept(greys({7, 7, 7, 7}), SampleRule::greedy, 0), ElementsAre(0));
}

TEST(GreedyRule, KeepsTheEndsOfARamp) {
  EXPECT_THAT(kept(greys({10, 20, 30, 40, 50}), SampleRule::greedy, 0), ElementsAre(0, 4));
}

TEST(GreedyRule, KeepsAKink) {
  EXPECT_THAT(kept(greys({10, 20, 30, 25, 20}), SampleRule::greedy, 0), ElementsAre(0, 2, 4));
}

TEST(GreedyRule, KeepsNothingOfAConstantTailButItsStart) {
  EXPECT_THAT(kept(greys({10, 20, 30, 30, 30}), SampleRule::greedy, 0), ElementsAre(0, 2));
}

TEST(GreedyRule, LooksBeyondAnEndThatFails) {
  // To layer 2 the line has 1 (a half, rounded up) at layer 1; to layer 3 it has 0 and 1 as it should.
  EXPECT_THAT(kept(greys({0, 0, 1, 1, 9}), SampleRule::greedy, 0), ElementsAre(0, 3, 4));
}

TEST(GreedyRule, BoundsTheSumOverTheComponents) {
  EXPECT_THAT(kept(texel_of({{9, 9, 9}, {10, 10, 10}, {9, 9, 9}}), SampleRule::greedy, 3),
              ElementsAre(0, 1, 2));
  EXPECT_THAT(kept(texel_of({{9, 9, 9}, {10, 10, 9}, {9, 9, 9}}), SampleRule::greedy, 3), ElementsAre(0));
}

RC_GTEST_PROP(GreedyRule, KeepsItsBound, ()) {
  const ByteStack stack = any_stack();
  const int threshold = *rc::gen::element(0, 1, 6, 9, 30);
  const ByteStack decoded = decode_piecewise(encode_piecewise(stack, SampleRule::greedy, threshold));
  RC_ASSERT(max_error(stack, decoded) < std::max(threshold, 1));
}

bool line_is_near(const std::vector<Rgb8>& values, std::size_t from, std::size_t to, int threshold) {
  for (std::size_t i = from; i <= to; ++i) {
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c)
      sum +=
          std::abs(values[i][c] - interpolate(values[from][c], values[to][c], int(i - from), int(to - from)));
    if (sum >= std::max(threshold, 1)) return false;
  }
  return true;
}

RC_GTEST_PROP(GreedyRule, GoesAsFarAsAnyLineDoes, ()) {
  const std::vector<Rgb8> values = any_texel();
  const int threshold = *rc::gen::element(0, 1, 6, 9, 30);
  const std::vector<std::uint16_t> layers = kept(texel_of(values), SampleRule::greedy, threshold);
  for (std::size_t s = 0; s + 1 < layers.size(); ++s)
    for (std::size_t beyond = layers[s + 1] + 1; beyond < values.size(); ++beyond)
      RC_ASSERT_FALSE(line_is_near(values, layers[s], beyond, threshold));
}

TEST(PaperRule, KeepsTheKinkItself) {
  EXPECT_THAT(kept(greys({10, 20, 30, 25, 20}), SampleRule::paper, 0), ElementsAre(0, 2, 4));
  EXPECT_THAT(kept(greys({7, 7, 7, 7}), SampleRule::paper, 0), ElementsAre(0));
}

TEST(PaperRule, ComparesTheSumOfChangesOfStep) {
  // Steps change by 2 in each component: 6 in all.
  EXPECT_THAT(kept(greys({10, 20, 32}), SampleRule::paper, 6), ElementsAre(0, 1, 2));
  EXPECT_THAT(kept(greys({10, 20, 32}), SampleRule::paper, 7), ElementsAre(0, 2));
}

TEST(PaperRule, ComparesTheChangeOfOneComponentWithHalfOfTheThreshold) {
  EXPECT_THAT(kept(texel_of({{10, 0, 0}, {20, 0, 0}, {33, 0, 0}}), SampleRule::paper, 6),
              ElementsAre(0, 1, 2));
  EXPECT_THAT(kept(texel_of({{10, 0, 0}, {20, 0, 0}, {32, 0, 0}}), SampleRule::paper, 6), ElementsAre(0, 2));
}

TEST(PaperRule, KeepsExtremes) {
  EXPECT_THAT(kept(texel_of({{10, 0, 0}, {11, 0, 0}, {10, 0, 0}}), SampleRule::paper, 9),
              ElementsAre(0, 1, 2));
}

TEST(PaperRule, ComparesWithTheFirstStepAfterAKeptSample) {
  // Each step is 1 longer than the one before; the third is 2 longer than the first, 6 over the components.
  EXPECT_THAT(kept(greys({10, 20, 31, 43, 56, 70}), SampleRule::paper, 6), ElementsAre(0, 2, 4, 5));
}

RC_GTEST_PROP(PaperRule, IsLosslessAtThreshold0, ()) {
  const ByteStack stack = any_stack();
  const PiecewiseStack encoded = encode_piecewise(stack, SampleRule::paper, *rc::gen::element(0, 1));
  RC_ASSERT(decode_piecewise(encoded).texels == stack.texels);
}

RC_GTEST_PROP(PaperRule, KeepsTrueValuesWhereItSamples, ()) {
  const ByteStack stack = any_stack();
  const PiecewiseStack encoded = encode_piecewise(stack, SampleRule::paper, *rc::gen::element(6, 9, 30));
  for (std::size_t texel = 0; texel < encoded.texels(); ++texel)
    for (std::size_t s = encoded.first_sample[texel]; s < encoded.samples_end(texel); ++s)
      RC_ASSERT(encoded.color(s) == stack.texels[encoded.layers[s] * stack.layer_size() + texel]);
}

TEST(PiecewiseEncoder, SharedColorsAreIndexed) {
  const PiecewiseStack encoded = encode_piecewise(greys({5, 9, 5, 9}), SampleRule::greedy, 0);
  EXPECT_THAT(encoded.color_indices, ElementsAre(0, 1, 0, 1));
  EXPECT_THAT(encoded.colors, ElementsAre(Rgb8{5, 5, 5}, Rgb8{9, 9, 9}));
}

TEST(PiecewiseEncoder, IndicesReach65536Colors) {
  ByteStack stack{256, 256, {2, 1}, 1, {}};
  for (int layer = 0; layer < 2; ++layer)
    for (int i = 0; i < 65536; ++i) stack.texels.push_back({std::uint8_t(i), std::uint8_t(i >> 8), 0});
  EXPECT_EQ(encode_piecewise(stack, SampleRule::greedy, 0).color_indices.size(), 65536u);
  stack.texels[65536] = {0, 0, 1};
  const PiecewiseStack one_more = encode_piecewise(stack, SampleRule::greedy, 0);
  EXPECT_TRUE(one_more.color_indices.empty());
  EXPECT_EQ(one_more.colors.size(), 65537u);
  EXPECT_EQ(decode_piecewise(one_more).texels, stack.texels);
}

TEST(PiecewiseEncoder, SerpentineSavesSamplesOnAShinyWall) {
  const auto samples = [](LayerOrder order) {
    const SyntheticWall wall{.width = 40, .height = 20, .grid = {20, 20, order}};
    return encode_piecewise(to_bytes(make_stack(wall)), SampleRule::greedy, 6).layers.size();
  };
  const std::size_t serpentine = samples(LayerOrder::phi_serpentine);
  EXPECT_LT(serpentine, samples(LayerOrder::phi_major));
  EXPECT_LT(serpentine, samples(LayerOrder::theta_major));
}

}  // namespace
}  // namespace lightbench
