#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "base/error.h"
#include "reports/metrics/luv.h"
#include "tests/reports/metric_pair.h"

namespace lightbench {
namespace {

using test::compute;
using test::pattern;
using test::row_of;

double value_of(const MetricValue& value) {
  EXPECT_TRUE(value.value.has_value()) << value.undefined_because;
  return value.value.value_or(std::nan(""));
}

TEST(MetricTable, NamesAreUniqueAndRowsComplete) {
  std::vector<std::string> names;
  for (const Metric& metric : metrics()) {
    names.push_back(metric.name);
    EXPECT_NE(metric.compute, nullptr) << metric.name;
    EXPECT_FALSE(metric.doc.empty()) << metric.name;
  }
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

TEST(MetricTable, UnknownNameSaysTheNearest) {
  try {
    find_metric("mean_eror", "job.json: $.metrics[0]");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'mean_error'"));
    EXPECT_EQ(error.where(), "job.json: $.metrics[0]");
  }
}

TEST(MeanError, IsTheSumOverComponentsByHand) {
  // |10-13| + |20-18| + |30-30| + |0-255| + 0 + |7-6| = 261 over 6 components.
  const Image8 a = row_of({{10, 20, 30}, {0, 5, 7}});
  const Image8 b = row_of({{13, 18, 30}, {255, 5, 6}});
  EXPECT_DOUBLE_EQ(value_of(compute("mean_error", a, b)), 261.0 / 6.0);
}

TEST(MeanError, OneChangedPixelOfALargeImage) {
  // More than one block of the summing loop, and a remainder.
  const Image8 a = pattern(301, 211, 1);
  Image8 b = a;
  b.pixel(300, 210)[2] ^= 0x80;
  EXPECT_DOUBLE_EQ(value_of(compute("mean_error", a, b)), 128.0 / (3.0 * 301 * 211));
}

TEST(MeanError, BlackToWhiteIs255AtAnySize) {
  const Image8 black(513, 257, 3, 0), white(513, 257, 3, 255);
  EXPECT_DOUBLE_EQ(value_of(compute("mean_error", black, white)), 255.0);
}

TEST(Rmse, IsByHand) {
  // (9 + 16) / 6 components.
  const Image8 a = row_of({{10, 20, 30}, {1, 2, 3}});
  const Image8 b = row_of({{13, 16, 30}, {1, 2, 3}});
  EXPECT_DOUBLE_EQ(value_of(compute("rmse", a, b)), std::sqrt(25.0 / 6.0));
}

TEST(Rmse, BlackToWhiteDoesNotOverflow) {
  const Image8 black(1024, 64, 3, 0), white(1024, 64, 3, 255);
  EXPECT_DOUBLE_EQ(value_of(compute("rmse", black, white)), 255.0);
}

TEST(Pearson, IsByHand) {
  // a = 1 2 3, b = 1 3 2: means 2 and 2, covariance 1/3, variances 2/3 each.
  EXPECT_DOUBLE_EQ(value_of(compute("pearson", row_of({{1, 2, 3}}), row_of({{1, 3, 2}}))), 0.5);
}

TEST(Pearson, PoolsComponentsOfAllPixels) {
  // Two grey pixels are six values; per pixel there would be no variance at all.
  const Image8 a = row_of({{10, 10, 10}, {20, 20, 20}});
  const Image8 b = row_of({{50, 50, 50}, {90, 90, 90}});
  EXPECT_DOUBLE_EQ(value_of(compute("pearson", a, b)), 1.0);
}

TEST(Pearson, NegativeImageIsMinusOne) {
  const Image8 a = pattern(97, 61, 3);
  Image8 b = a;
  for (auto& component : b.data) component = std::uint8_t(255 - component);
  EXPECT_EQ(value_of(compute("pearson", a, b)), -1.0);
}

TEST(Pearson, ConstantImageIsUndefinedAndSaysWhich) {
  const Image8 constant(4, 4, 3, 77), other = pattern(4, 4, 1);
  EXPECT_EQ(compute("pearson", constant, other), MetricValue::undefined("the reference is constant"));
  EXPECT_EQ(compute("pearson", other, constant), MetricValue::undefined("the image is constant"));
}

TEST(Pearson, MatchesTheTwoPassFormulaOnALargeImage) {
  const Image8 a = pattern(640, 480, 4);
  Image8 b = pattern(640, 480, 5);
  for (std::size_t i = 0; i < b.data.size(); ++i) b.data[i] = std::uint8_t((a.data[i] + b.data[i]) / 2);
  const double n = double(a.data.size());
  double mean_a = 0, mean_b = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i) mean_a += a.data[i] / n, mean_b += b.data[i] / n;
  double aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.data.size(); ++i) {
    const double x = a.data[i] - mean_a, y = b.data[i] - mean_b;
    aa += x * x, bb += y * y, ab += x * y;
  }
  // 1e-9: a million additions in double precision; ours are exact.
  EXPECT_NEAR(value_of(compute("pearson", a, b)), ab / std::sqrt(aa * bb), 1e-9);
}

TEST(LuminanceError, WeighsComponentsAsTheThesisDoes) {
  // |0.27*10 - 0.67*5 + 0.06*20| = |2.7 - 3.35 + 1.2| = 0.55, and 0 for the second pixel.
  const Image8 a = row_of({{110, 50, 120}, {1, 2, 3}});
  const Image8 b = row_of({{100, 55, 100}, {1, 2, 3}});
  EXPECT_DOUBLE_EQ(value_of(compute("luminance_error", a, b)), 0.55 / 2);
}

TEST(LuminanceError, BlackToWhiteIs255) {
  const Image8 black(700, 300, 3, 0), white(700, 300, 3, 255);
  EXPECT_DOUBLE_EQ(value_of(compute("luminance_error", black, white)), 255.0);
}

TEST(Luv, KnownDistancesBetweenPrimaries) {
  // 0.05: the known distances are rounded to one decimal.
  EXPECT_NEAR(value_of(compute("luv", row_of({{0, 255, 0}}), row_of({{255, 0, 255}}))), 274.6, 0.05);
  EXPECT_NEAR(value_of(compute("luv", row_of({{255, 0, 0}}), row_of({{0, 0, 255}}))), 250.4, 0.05);
}

TEST(Luv, BlackToWhiteIsTheLightnessRange) {
  // 1e-4: single precision of values up to 100.
  EXPECT_NEAR(value_of(compute("luv", row_of({{0, 0, 0}}), row_of({{255, 255, 255}}))), 100.0, 1e-4);
}

TEST(Luv, GreysHaveNoChroma) {
  for (int grey = 0; grey < 256; ++grey) {
    const auto g = std::uint8_t(grey);
    const Luv color = to_luv(g, g, g);
    EXPECT_NEAR(color.u, 0, 1e-10) << grey;
    EXPECT_NEAR(color.v, 0, 1e-10) << grey;
  }
}

TEST(Luv, MidGreyHasItsPublishedLightness) {
  // L* of sRGB 119 is 50.03.
  EXPECT_NEAR(to_luv(119, 119, 119).l, 50.03, 0.01);
}

TEST(Luv, FastPathMatchesDoublePrecision) {
  rc::check([](std::array<std::uint8_t, 3> a, std::array<std::uint8_t, 3> b) {
    const Luv x = to_luv(a[0], a[1], a[2]), y = to_luv(b[0], b[1], b[2]);
    const double expected = std::hypot(x.l - y.l, x.u - y.u, x.v - y.v);
    const double fast = *compute("luv", row_of({a}), row_of({b})).value;
    // Single precision: u* is 13 L* times a difference of chromaticities with an error of some 1e-7.
    RC_ASSERT(std::abs(fast - expected) < 1e-3);
  });
}

TEST(Luv, OnlyTheMasksPixelsCount) {
  const Image8 a = row_of({{0, 0, 0}, {0, 0, 0}, {9, 9, 9}});
  const Image8 b = row_of({{255, 255, 255}, {200, 0, 0}, {9, 9, 9}});
  const std::vector<std::uint8_t> mask{255, 0, 1};
  EXPECT_NEAR(value_of(compute("luv", a, b, nullptr, &mask)), 50.0, 1e-4);
}

TEST(Luv, EmptyMaskIsUndefined) {
  const Image8 a = row_of({{1, 2, 3}});
  const std::vector<std::uint8_t> mask{0};
  EXPECT_EQ(compute("luv", a, a, nullptr, &mask), MetricValue::undefined("the mask is empty"));
}

TEST(Gain, IsThePercentageOfTheBaselinesError) {
  const Image8 reference = row_of({{100, 100, 100}});
  const Image8 baseline = row_of({{80, 100, 100}});
  EXPECT_DOUBLE_EQ(value_of(compute("gain", reference, row_of({{95, 100, 100}}), &baseline)), 75.0);
  EXPECT_DOUBLE_EQ(value_of(compute("gain", reference, row_of({{100, 130, 100}}), &baseline)), -50.0);
}

TEST(Gain, OverABaselineWithoutErrorIsUndefined) {
  const Image8 reference = pattern(3, 3, 1), other = pattern(3, 3, 2);
  EXPECT_EQ(compute("gain", reference, other, &reference),
            MetricValue::undefined("the baseline has no error"));
}

TEST(Quality, SaysWhichOfTheTwoIsCloser) {
  const Image8 reference = row_of({{100, 100, 100}});
  const Image8 near = row_of({{101, 100, 100}}), far = row_of({{100, 98, 100}});
  EXPECT_EQ(value_of(compute("quality", reference, near, &far)), -1);
  EXPECT_EQ(value_of(compute("quality", reference, far, &near)), 1);
}

TEST(Quality, TiesAreExact) {
  const Image8 reference = row_of({{100, 100, 100}});
  const Image8 up = row_of({{101, 101, 100}}), down = row_of({{100, 100, 98}});
  EXPECT_EQ(value_of(compute("quality", reference, up, &down)), 0);
}

TEST(Closeness, CountsPixelsByTheirSummedError) {
  const Image8 reference(4, 1, 3, 100);
  const Image8 baseline = row_of({{110, 100, 100}, {100, 100, 100}, {103, 103, 100}, {100, 90, 100}});
  const Image8 image = row_of({{100, 109, 100}, {100, 100, 101}, {100, 100, 94}, {100, 91, 100}});
  EXPECT_DOUBLE_EQ(value_of(compute("closer", reference, image, &baseline)), 50.0);
  EXPECT_DOUBLE_EQ(value_of(compute("farther", reference, image, &baseline)), 25.0);
  EXPECT_DOUBLE_EQ(value_of(compute("equal", reference, image, &baseline)), 25.0);
}

TEST(Metrics, IdenticalPairHasNoErrorAndFullCorrelation) {
  const Image8 image = pattern(131, 77, 9), baseline = pattern(131, 77, 10);
  const std::map<std::string, double> expected{{"mean_error", 0},      {"rmse", 0},    {"luv", 0},
                                               {"luminance_error", 0}, {"pearson", 1}, {"gain", 100},
                                               {"quality", -1},        {"farther", 0}};
  for (const auto& [name, value] : expected)
    EXPECT_EQ(value_of(compute(name, image, image, &baseline)), value) << name;
}

TEST(Metrics, SymmetricOnesDoNotCareWhichImageIsFirst) {
  const Image8 a = pattern(53, 31, 1), b = pattern(53, 31, 2);
  for (const char* name : {"mean_error", "rmse", "luv", "luminance_error", "pearson"})
    EXPECT_EQ(compute(name, a, b), compute(name, b, a)) << name;
}

TEST(Metrics, OrderOfPixelsDoesNotMatter) {
  const Image8 a = pattern(701, 97, 1), b = pattern(701, 97, 2), baseline = pattern(701, 97, 3);
  const auto reversed = [](const Image8& image) {
    Image8 result = image;
    for (std::size_t i = 0, n = image.pixel_count(); i < n; ++i)
      for (std::size_t c = 0; c < 3; ++c) result.data[3 * i + c] = image.data[3 * (n - 1 - i) + c];
    return result;
  };
  const Image8 reversed_baseline = reversed(baseline);
  for (const Metric& metric : metrics())
    EXPECT_EQ(compute(metric.name, a, b, &baseline),
              compute(metric.name, reversed(a), reversed(b), &reversed_baseline))
        << metric.name;
}

TEST(Metrics, BaselineMetricsAreUndefinedWithoutOne) {
  const Image8 image = pattern(5, 5, 1);
  for (const Metric& metric : metrics()) {
    if (!metric.needs_baseline) continue;
    EXPECT_EQ(compute(metric.name, image, image), MetricValue::undefined("there is no baseline"))
        << metric.name;
  }
}

TEST(Metrics, DifferentSizesAreAnErrorThatNamesBoth) {
  try {
    compute("mean_error", Image8(4, 3, 3), Image8(3, 4, 3));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("4x3"), testing::HasSubstr("3x4")));
  }
}

TEST(Metrics, EmptyImagesAreAnError) {
  EXPECT_THROW(compute("mean_error", Image8(), Image8()), Error);
}

TEST(Metrics, FourComponentsAreAnError) {
  EXPECT_THROW(compute("mean_error", Image8(2, 2, 4), Image8(2, 2, 4)), Error);
}

TEST(Metrics, AMaskOfAnotherSizeIsAnError) {
  const Image8 image(2, 2, 3);
  const std::vector<std::uint8_t> mask(3, 1);
  EXPECT_THROW(compute("luv", image, image, nullptr, &mask), Error);
}

TEST(ObjectMask, TakesPixelsCoveredByAtLeastHalf) {
  Image8 image(3, 1, 4, 0);
  image.pixel(0, 0)[3] = 127;
  image.pixel(1, 0)[3] = 128;
  image.pixel(2, 0)[3] = 255;
  EXPECT_EQ(object_mask(image), (std::vector<std::uint8_t>{0, 1, 1}));
}

TEST(ObjectMask, IsEverythingWithoutAlpha) {
  EXPECT_EQ(object_mask(Image8(2, 1, 3, 0)), (std::vector<std::uint8_t>{1, 1}));
}

/// The flicker of two frames of these rows of pixels.
MetricValue flicker_of(const Image8& reference, const Image8& image, const PreviousFrame& previous,
                       const std::vector<std::uint8_t>* mask = nullptr) {
  MetricInput input{reference, image};
  input.mask = mask;
  input.previous = &previous;
  return compute_metrics({"flicker"}, input).at("flicker");
}

TEST(Flicker, OfAnErrorThatStaysIsNothing) {
  // Both images are 5 too dark, whatever the pictures show.
  const Image8 reference = row_of({{10, 20, 30}}), image = row_of({{5, 15, 25}});
  const Image8 reference_before = row_of({{200, 100, 50}}), image_before = row_of({{195, 95, 45}});
  EXPECT_DOUBLE_EQ(value_of(flicker_of(reference, image, {reference_before, image_before})), 0);
}

TEST(Flicker, OfOneComponentThatIsOffByOneInOneFrame) {
  const Image8 a = pattern(7, 5, 1), b = pattern(7, 5, 2);
  Image8 changed = b;
  changed.pixel(3, 2)[1] ^= 1;
  EXPECT_DOUBLE_EQ(value_of(flicker_of(a, b, {a, changed})), 1.0 / (3 * 7 * 5));
}

TEST(Flicker, SeesAnErrorThatChangesItsSign) {
  // The absolute error is 10 in both frames.
  const Image8 reference = row_of({{100, 100, 100}});
  EXPECT_DOUBLE_EQ(
      value_of(flicker_of(reference, row_of({{110, 110, 110}}), {reference, row_of({{90, 90, 90}})})), 20);
}

TEST(Flicker, CountsWhatIsAnObjectInBothFrames) {
  const Image8 reference = row_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  const Image8 image = row_of({{9, 9, 9}, {6, 6, 6}, {3, 3, 3}});
  const std::vector<std::uint8_t> now = {1, 1, 0}, before = {0, 1, 1}, nowhere = {0, 0, 0};
  EXPECT_DOUBLE_EQ(value_of(flicker_of(reference, image, {reference, reference, &before}, &now)), 6);
  EXPECT_THAT(flicker_of(reference, image, {reference, reference, &nowhere}, &now).undefined_because,
              testing::HasSubstr("no pixel"));
}

TEST(Flicker, WithoutAFrameBeforeIsUndefined) {
  const Image8 a = pattern(2, 2, 1);
  EXPECT_THAT(compute("flicker", a, a).undefined_because, testing::HasSubstr("no frame before"));
}

TEST(Flicker, OfAFrameOfAnotherSizeIsAnError) {
  const Image8 a = pattern(2, 2, 1), small = pattern(2, 1, 1);
  EXPECT_THROW(flicker_of(a, a, {a, small}), Error);
  EXPECT_THROW(flicker_of(a, a, {small, a}), Error);
  const std::vector<std::uint8_t> short_mask = {1};
  EXPECT_THROW(flicker_of(a, a, {a, a, &short_mask}), Error);
}

TEST(SequenceMetrics, AreNoDefault) {
  EXPECT_THAT(default_metrics(), testing::Not(testing::Contains("flicker")));
  EXPECT_THAT(sequence_metrics(), testing::ElementsAre("flicker"));
  EXPECT_FALSE(needs_previous(default_metrics()));
}

}  // namespace
}  // namespace lightbench
