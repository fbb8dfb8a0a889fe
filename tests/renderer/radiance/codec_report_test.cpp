#include "renderer/radiance/codec_report.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"

namespace lightbench {
namespace {

ByteStack grey(int width, std::uint8_t value) {
  ByteStack stack{width, 1, {2, 1}, 1, {}};
  stack.texels.assign(std::size_t(width) * 2, {value, value, value});
  return stack;
}

TEST(CodecReport, OfAnIdenticalPair) {
  const CodecReport report = report_codec(grey(5, 9), grey(5, 9), {{"a", 4}, {"b", 6}});
  EXPECT_EQ(report.width, 5);
  EXPECT_EQ(report.height, 1);
  EXPECT_EQ(report.texels, 5u);
  EXPECT_EQ(report.directions, 2);
  EXPECT_EQ(report.raw_bytes, 30u);
  EXPECT_EQ(report.ratio, 3);
  EXPECT_EQ(report.colors, 1u);
  EXPECT_EQ(report.changed, 0);
  EXPECT_EQ(report.mean_changed_error, 0);
  EXPECT_EQ(report.error_99, 0);
  EXPECT_EQ(report.max_error, 0);
  EXPECT_EQ(report.max_component_error, 0);
}

TEST(CodecReport, AveragesOverChangedValuesAlone) {
  const ByteStack original = grey(5, 9);
  ByteStack decoded = original;
  decoded.texels[2] = {10, 9, 7};  // 1, 0 and 2
  decoded.texels[7] = {9, 15, 9};  // 6
  const CodecReport report = report_codec(original, decoded, {{"a", 1}});
  EXPECT_EQ(report.changed_values, 2u);
  EXPECT_DOUBLE_EQ(report.changed, 0.2);
  EXPECT_DOUBLE_EQ(report.mean_changed_error, 1.5);
  EXPECT_DOUBLE_EQ(report.max_error, 2);
  EXPECT_EQ(report.max_component_error, 6);
}

TEST(CodecReport, OneValueOfAHundredIsBeyondThe99thPercentile) {
  const ByteStack original = grey(100, 9);
  ByteStack decoded = original;
  decoded.texels[0] = decoded.texels[1] = {12, 12, 12};
  EXPECT_EQ(report_codec(original, decoded, {}).error_99, 0);
  decoded.texels[2] = {12, 12, 12};
  EXPECT_EQ(report_codec(original, decoded, {}).error_99, 3);
}

TEST(CodecReport, CountsTheColorsOfTheOriginal) {
  ByteStack original = grey(3, 9);
  original.texels[4] = {9, 9, 8};
  EXPECT_EQ(report_codec(original, grey(3, 1), {}).colors, 2u);
}

TEST(CodecReport, PlacesWithoutATexelDoNotCount) {
  const ByteStack original = grey(4, 9);
  ByteStack decoded = original;
  decoded.texels[1] = decoded.texels[5] = {200, 0, 0};  // one place in both layers
  const std::vector<std::uint8_t> counts{1, 0, 1, 1};
  const CodecReport report = report_codec(original, decoded, {{"a", 9}}, counts);
  EXPECT_EQ(report.max_error, 0);
  EXPECT_EQ(report.texels, 3u);
  EXPECT_EQ(report.raw_bytes, 18u);
  EXPECT_EQ(report.ratio, 2);
}

TEST(CodecReport, WithoutAnyTexelItHoldsNumbers) {
  const std::vector<std::uint8_t> counts(4, 0);
  for (const auto& [name, value] : codec_numbers(report_codec(grey(4, 9), grey(4, 9), {{"a", 9}}, counts)))
    EXPECT_TRUE(std::isfinite(value)) << name;
}

TEST(CodecReport, ObjectsOfDifferentShapeAreAnError) {
  EXPECT_THROW(report_codec(grey(3, 1), grey(4, 1), {}), Error);
  ByteStack turned = grey(3, 1);
  turned.grid.order = LayerOrder::theta_major;
  EXPECT_THROW(report_codec(grey(3, 1), turned, {}), Error);
}

}  // namespace
}  // namespace lightbench
