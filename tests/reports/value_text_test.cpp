#include "reports/value_text.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/reports/sample_run.h"

namespace lightbench {
namespace {

TEST(ValueText, HasTheMetricsDecimals) {
  EXPECT_EQ(value_text(metric_or_plain("gain"), MetricValue::of(27.316)), "27.32");
  EXPECT_EQ(value_text(metric_or_plain("quality"), MetricValue::of(-1)), "-1");
}

TEST(ValueText, HasNoNegativeZero) {
  EXPECT_EQ(value_text(metric_or_plain("gain"), MetricValue::of(-0.001)), "0.00");
}

TEST(ValueText, UndefinedAndNotANumberAreADash) {
  EXPECT_EQ(value_text(metric_or_plain("gain"), MetricValue::undefined("why")), "-");
  EXPECT_EQ(value_text(metric_or_plain("gain"), MetricValue::of(std::nan(""))), "-");
}

TEST(ValueText, MetricOfAnotherVersionStillHasAName) {
  EXPECT_EQ(metric_or_plain("flip").name, "flip");
}

TEST(DurationText, PicksItsUnit) {
  EXPECT_EQ(duration_text(0.0849), "85 ms");
  EXPECT_EQ(duration_text(0.9999), "1.0 s");
  EXPECT_EQ(duration_text(9.96), "10 s");
  EXPECT_EQ(duration_text(59.7), "1 min 0 s");
  EXPECT_EQ(duration_text(7500), "2 h 5 min");
}

TEST(CountOutcomes, CountsViewsFailuresAndGates) {
  const RunCounts counts = count_outcomes(test::sample_run());
  EXPECT_EQ(counts.views, 2u);
  EXPECT_EQ(counts.failed, 3u);
  EXPECT_EQ(counts.gates_met, 2u);
  EXPECT_EQ(counts.gates_within_noise, 1u);
  EXPECT_EQ(counts.gates_not_met, 1u);
}

TEST(FailedTasks, AreThoseOfObjectsImagesAndScores) {
  std::vector<std::string> what;
  for (const FailedTask& task : failed_tasks(test::sample_run())) what.push_back(task.what);
  EXPECT_EQ(what, (std::vector<std::string>{"compression of <b>wall</b>|`x` (packed)", "isr-48",
                                            "isr-48 against povray"}));
}

TEST(VerdictText, SaysWhatTheRunCameTo) {
  EXPECT_EQ(verdict_text({.gates_met = 5}), "All 5 gates met");
  EXPECT_EQ(verdict_text({.failed = 2, .gates_met = 4, .gates_not_met = 1}),
            "1 of 5 gates not met, 2 tasks failed");
  EXPECT_EQ(verdict_text({.gates_met = 2, .gates_not_judged = 1}), "1 of 3 gates not judged");
  EXPECT_EQ(verdict_text({.gates_met = 2, .gates_not_met = 1, .gates_not_judged = 1}),
            "1 of 4 gates not met, 1 not judged");
  EXPECT_EQ(verdict_text({.skipped = 1}), "1 task skipped");
  EXPECT_EQ(verdict_text({}), "Finished");
}

TEST(WorstFirst, FollowsTheMetricsDirectionWithUnknownOnesFirst) {
  RunReport run;
  for (const double gain : {5.0, -3.0, 20.0}) {
    ReportScore score;
    score.variant = "v";
    score.reference = "r";
    score.metrics = {{"gain", MetricValue::of(gain)}, {"mean_error", MetricValue::of(gain)}};
    run.scores.push_back(score);
  }
  run.scores[2].outcome = Outcome::failed;
  const auto by_gain = worst_first(run, "gain", "v", "r");
  EXPECT_EQ(by_gain, (std::vector<const ReportScore*>{&run.scores[2], &run.scores[1], &run.scores[0]}));
  const auto by_error = worst_first(run, "mean_error", "v", "r");
  EXPECT_EQ(by_error, (std::vector<const ReportScore*>{&run.scores[2], &run.scores[0], &run.scores[1]}));
}

TEST(DurationText, TellsTimesThatNoneHas) {
  EXPECT_EQ(duration_text(1e300), "1e+300 s");
  EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "inf s");
}

}  // namespace
}  // namespace lightbench
