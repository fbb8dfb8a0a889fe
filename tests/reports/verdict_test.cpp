#include "reports/verdict.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using testing::HasSubstr;

ReportScore score(const std::string& view, const std::string& variant, double gain) {
  ReportScore result;
  result.scene = view.substr(0, view.find('/'));
  result.view = view.substr(view.find('/') + 1);
  result.variant = variant;
  result.reference = "povray";
  result.metrics["gain"] = MetricValue::of(gain);
  return result;
}

RunReport run_of(std::vector<ReportScore> scores) {
  RunReport run;
  run.primary_reference = "povray";
  for (const char* name : {"direct", "isr-24", "isr-48"}) run.variants.push_back({name, "", {}, 0, ""});
  run.scores = std::move(scores);
  return run;
}

Gate gate(Gate::Over over, std::optional<double> min, std::optional<double> max = std::nullopt) {
  Gate result;
  result.metric = "gain";
  result.variant = "isr-48";
  result.over = over;
  result.min = min;
  result.max = max;
  return result;
}

const RunReport kRun =
    run_of({score("a/1", "isr-48", 10), score("a/2", "isr-48", 40), score("b/1", "isr-48", 4)});

TEST(Gate, MeanLooksAtTheMean) {
  EXPECT_TRUE(evaluate_gate(gate(Gate::Over::mean, 18), kRun).passed);
  const ReportGate failed = evaluate_gate(gate(Gate::Over::mean, 18.5), kRun);
  EXPECT_FALSE(failed.passed);
  EXPECT_EQ(failed.detail, "18 mean of 3 views, below 18.5");
}

TEST(Gate, BoundsAreInclusive) {
  EXPECT_TRUE(evaluate_gate(gate(Gate::Over::mean, 18, 18), kRun).passed);
}

TEST(Gate, WorstNamesTheViewForALowerBound) {
  const ReportGate result = evaluate_gate(gate(Gate::Over::worst, 5), kRun);
  EXPECT_FALSE(result.passed);
  EXPECT_EQ(result.detail, "4 on b/1, the worst of 3 views, below 5");
}

TEST(Gate, WorstIsTheLargestForAnUpperBound) {
  const ReportGate result = evaluate_gate(gate(Gate::Over::worst, std::nullopt, 30), kRun);
  EXPECT_FALSE(result.passed);
  EXPECT_THAT(result.detail, HasSubstr("40 on a/2"));
}

TEST(Gate, EachListsEveryViewThatBreaksIt) {
  const ReportGate result = evaluate_gate(gate(Gate::Over::each, 20), kRun);
  EXPECT_FALSE(result.passed);
  EXPECT_EQ(result.detail, "2 of 3 views: 10 on a/1, below 20; 4 on b/1, below 20");
  EXPECT_TRUE(evaluate_gate(gate(Gate::Over::each, 4), kRun).passed);
}

TEST(Gate, UndefinedValueIsNotMetAndSaysWhy) {
  RunReport run = kRun;
  run.scores[0].metrics["gain"] = MetricValue::undefined("the baseline has no error");
  for (const auto over : {Gate::Over::each, Gate::Over::mean, Gate::Over::worst}) {
    const ReportGate result = evaluate_gate(gate(over, -1000), run);
    EXPECT_FALSE(result.passed);
    EXPECT_EQ(result.detail, "a/1 has no gain: the baseline has no error");
  }
}

TEST(Gate, NotANumberIsNotMet) {
  RunReport run = kRun;
  run.scores[1].metrics["gain"] = MetricValue::of(std::nan(""));
  for (const auto over : {Gate::Over::each, Gate::Over::mean, Gate::Over::worst})
    EXPECT_FALSE(evaluate_gate(gate(over, -1000, 1000), run).passed);
}

TEST(Gate, FailedTaskIsNotMetAndSaysWhy) {
  RunReport run = kRun;
  run.scores[2].outcome = Outcome::failed;
  run.scores[2].error = "killed by signal 9";
  const ReportGate result = evaluate_gate(gate(Gate::Over::mean, 0), run);
  EXPECT_FALSE(result.passed);
  EXPECT_THAT(result.detail, AllOf(HasSubstr("b/1"), HasSubstr("killed by signal 9")));
}

TEST(Gate, MetricThatWasNotComputedIsNotMet) {
  Gate of_luv = gate(Gate::Over::each, 0);
  of_luv.metric = "luv";
  EXPECT_FALSE(evaluate_gate(of_luv, kRun).passed);
}

TEST(Gate, NothingToLookAtIsNotMet) {
  Gate nowhere = gate(Gate::Over::each, 0);
  nowhere.scene = "no such scene";
  const ReportGate result = evaluate_gate(nowhere, kRun);
  EXPECT_FALSE(result.passed);
  EXPECT_EQ(result.detail, "no score matches");
}

TEST(Gate, WithoutBoundsIsNotMet) {
  EXPECT_FALSE(evaluate_gate(gate(Gate::Over::each, std::nullopt), kRun).passed);
}

TEST(Gate, PatternsChooseScenesAndViews) {
  Gate only = gate(Gate::Over::each, 10);
  only.scene = "a*";
  EXPECT_TRUE(evaluate_gate(only, kRun).passed);
  only.view = "2";
  only.min = 40;
  EXPECT_TRUE(evaluate_gate(only, kRun).passed);
}

TEST(Gate, PatternOfVariantsMustHoldForEach) {
  Gate all = gate(Gate::Over::mean, 5);
  all.variant = "isr-*";
  const RunReport run =
      run_of({score("a/1", "isr-48", 10), score("a/1", "isr-24", 1), score("a/1", "direct", 0)});
  const ReportGate result = evaluate_gate(all, run);
  EXPECT_FALSE(result.passed);
  EXPECT_EQ(result.detail, "isr-24: 1 mean of 1 view, below 5");
}

TEST(Gate, LooksAtThePrimaryReferenceUnlessItNamesOne) {
  RunReport run = kRun;
  run.scores.push_back(score("a/1", "isr-48", -50));
  run.scores.back().reference = "path";
  EXPECT_TRUE(evaluate_gate(gate(Gate::Over::each, 0), run).passed);
  Gate against_path = gate(Gate::Over::each, 0);
  against_path.reference = "path";
  EXPECT_FALSE(evaluate_gate(against_path, run).passed);
}

TEST(Gate, KeepsTheJobsWords) {
  Gate written = gate(Gate::Over::mean, 25);
  EXPECT_EQ(evaluate_gate(written, kRun).text, "mean gain of isr-48 >= 25");
  written.as_written = "{\"metric\":\"gain\"}";
  EXPECT_EQ(evaluate_gate(written, kRun).text, "{\"metric\":\"gain\"}");
}

TEST(Gate, LongListsAreCut) {
  std::vector<ReportScore> scores;
  for (int i = 0; i < 80; ++i) scores.push_back(score("a/" + std::to_string(i), "isr-48", -1));
  const ReportGate result = evaluate_gate(gate(Gate::Over::each, 0), run_of(scores));
  EXPECT_THAT(result.detail, AllOf(HasSubstr("80 of 80 views"), HasSubstr("and 75 more")));
}

}  // namespace
}  // namespace lightbench
