#include "reports/cost_chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

/// Two views of variants with gain and processor time, against "truth" and the baseline "direct".
class CostChart : public ::testing::Test {
 protected:
  CostChart() {
    report_.baseline = "direct";
    report_.primary_reference = "truth";
    report_.references.push_back(named("truth"));
    add("direct", 0, 0.5);
  }
  static ReportImageSource named(const std::string& name) {
    ReportImageSource source;
    source.name = name;
    return source;
  }
  void add(const std::string& variant, double gain, double seconds) {
    report_.variants.push_back(named(variant));
    for (const double sign : {-1, 1}) {
      const std::string view = sign < 0 ? "a" : "b";
      ReportImage image;
      image.scene = "scene", image.view = view, image.source = variant;
      image.cpu_seconds = seconds + 0.1 * sign;
      image.contended = false;
      report_.images.push_back(image);
      ReportScore score;
      score.scene = "scene", score.view = view, score.variant = variant, score.reference = "truth";
      score.metrics["gain"] = MetricValue::of(gain + sign);
      report_.scores.push_back(score);
    }
  }
  RunReport report_;
};

TEST_F(CostChart, PointsAreMeansFromCheapToDear) {
  add("dear", 80, 3);
  add("cheap", 20, 1);
  const auto points = cost_points(report_);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].variant, "cheap");
  EXPECT_NEAR(points[0].seconds, 1, 1e-12);
  EXPECT_NEAR(points[0].gain, 20, 1e-12);
  EXPECT_EQ(points[1].variant, "dear");
}

TEST_F(CostChart, WhatIsBeatenIsNotOfTheFront) {
  add("cheap", 20, 1);
  add("worse and dearer", 10, 2);
  add("dear", 80, 3);
  const auto points = cost_points(report_);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_TRUE(points[0].front);
  EXPECT_FALSE(points[1].front);
  EXPECT_TRUE(points[2].front);
}

TEST_F(CostChart, ContendedTimesNameNoFront) {
  add("cheap", 20, 1);
  add("worse and dearer", 10, 2);
  add("dear", 80, 3);
  report_.images.back().contended = true;
  for (const CostPoint& point : cost_points(report_)) EXPECT_FALSE(point.front) << point.variant;
  EXPECT_THAT(cost_chart(report_), ::testing::HasSubstr(">worse and dearer</text>"))
      << "all have their names";
}

TEST_F(CostChart, TimesOfTheBaselineDoNotContend) {
  report_.images.front().contended = true;
  add("cheap", 20, 1);
  EXPECT_TRUE(cost_points(report_).at(0).front);
}

TEST_F(CostChart, VariantsWithoutTimeOrGainHaveNoPoint) {
  add("untimed", 20, 1);
  for (ReportImage& image : report_.images)
    if (image.source == "untimed") image.cpu_seconds = 0;
  report_.variants.push_back(named("failed"));
  EXPECT_TRUE(cost_points(report_).empty());
}

TEST_F(CostChart, NeedsThreeVariants) {
  add("a", 20, 1);
  add("b", 30, 2);
  EXPECT_EQ(cost_chart(report_), "");
  add("c", 40, 3);
  EXPECT_THAT(cost_chart(report_), ::testing::StartsWith("<svg"));
}

TEST_F(CostChart, ManyLikeVariantsFindTheirPlaces) {
  for (int i = 0; i < 60; ++i) add("variant " + std::to_string(i), 50 + 0.01 * i, 1 + 0.001 * i);
  const std::string chart = cost_chart(report_);
  for (int i = 0; i < 60; ++i)
    EXPECT_THAT(chart, ::testing::HasSubstr(">variant " + std::to_string(i) + "</text>"));
}

TEST_F(CostChart, NamesAreText) {
  add("</text><script>", 20, 1);
  add("b", 30, 2);
  add("c", 40, 3);
  EXPECT_THAT(cost_chart(report_), ::testing::Not(::testing::HasSubstr("<script>")));
}

TEST_F(CostChart, NumbersThatNoRunHasMakeNoEndlessChart) {
  add("huge", 1e300, 1e300);
  add("tiny", -1e300, 0.2);
  add("plain", 50, 1);
  EXPECT_LT(cost_chart(report_).size(), 1'000'000u);
}

}  // namespace
}  // namespace lightbench
