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
  for (const char* name : {"direct", "isr-24", "isr-48"})
    run.variants.push_back({name, "", {}, 0, false, ""});
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
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::mean, 18), kRun).state, GateState::met);
  const ReportGate failed = evaluate_gate(gate(Gate::Over::mean, 18.5), kRun);
  EXPECT_EQ(failed.state, GateState::not_met);
  EXPECT_EQ(failed.detail, "18 mean of 3 views, below 18.5");
}

TEST(Gate, BoundsAreInclusive) {
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::mean, 18, 18), kRun).state, GateState::met);
}

TEST(Gate, WorstNamesTheViewForALowerBound) {
  const ReportGate result = evaluate_gate(gate(Gate::Over::worst, 5), kRun);
  EXPECT_EQ(result.state, GateState::not_met);
  EXPECT_EQ(result.detail, "4 on b/1, the worst of 3 views, below 5");
}

TEST(Gate, WorstIsTheLargestForAnUpperBound) {
  const ReportGate result = evaluate_gate(gate(Gate::Over::worst, std::nullopt, 30), kRun);
  EXPECT_EQ(result.state, GateState::not_met);
  EXPECT_THAT(result.detail, HasSubstr("40 on a/2"));
}

TEST(Gate, EachListsEveryViewThatBreaksItWorstFirst) {
  const ReportGate result = evaluate_gate(gate(Gate::Over::each, 20), kRun);
  EXPECT_EQ(result.state, GateState::not_met);
  EXPECT_EQ(result.detail, "2 of 3 views: 4 on b/1, below 20; 10 on a/1, below 20");
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::each, 4), kRun).state, GateState::met);
}

TEST(Gate, EachShowsTheWorstOfManyViewsThatBreakIt) {
  std::vector<ReportScore> scores;
  for (int i = 0; i < 9; ++i) scores.push_back(score("a/" + std::to_string(i), "isr-48", 9 - i));
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::each, 20), run_of(scores)).detail,
            "9 of 9 views: 1 on a/8, below 20; 2 on a/7, below 20; 3 on a/6, below 20; 4 on a/5, below 20; "
            "5 on a/4, below 20; and 4 more");
}

TEST(Gate, OfAPatternNamesTheWorstVariantFirst) {
  Gate any = gate(Gate::Over::mean, 20);
  any.variant = "isr-*";
  const ReportGate result =
      evaluate_gate(any, run_of({score("a/1", "isr-24", 10), score("a/1", "isr-48", 5)}));
  EXPECT_EQ(result.detail, "isr-48: 5 mean of 1 view, below 20; isr-24: 10 mean of 1 view, below 20");
}

TEST(GateViews, AreThereForAGateOnEachViewAlone) {
  EXPECT_TRUE(evaluate_gate(gate(Gate::Over::mean, 20), kRun).views.empty());
  EXPECT_TRUE(evaluate_gate(gate(Gate::Over::worst, 20), kRun).views.empty());
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::each, 20), kRun).views.size(), 3u);
}

TEST(GateViews, StandWorstFirstWithTheirValues) {
  const std::vector<ReportGateView> views = evaluate_gate(gate(Gate::Over::each, 20), kRun).views;
  ASSERT_EQ(views.size(), 3u);
  EXPECT_EQ(views[0].scene + "/" + views[0].view, "b/1");
  EXPECT_EQ(views[0].state, GateState::not_met);
  EXPECT_EQ(views[0].detail, "4, below 20");
  EXPECT_EQ(views[1].detail, "10, below 20");
  EXPECT_EQ(views[2].state, GateState::met);
  EXPECT_EQ(views[2].detail, "40");
  EXPECT_EQ(views[2].variant, "") << "it is the gate's";
}

TEST(GateViews, WithoutANumberAreTheWorst) {
  RunReport run = kRun;
  run.scores[1].metrics["gain"] = MetricValue::undefined("the baseline has no error");
  const std::vector<ReportGateView> views = evaluate_gate(gate(Gate::Over::each, 5), run).views;
  ASSERT_EQ(views.size(), 3u);
  EXPECT_EQ(views[0].view, "2");
  EXPECT_EQ(views[0].state, GateState::not_met);
  EXPECT_THAT(views[0].detail, HasSubstr("the baseline has no error"));
}

TEST(GateViews, ThatWereNotMeasuredAreNotJudged) {
  RunReport run = kRun;
  run.scores[0].outcome = Outcome::skipped;
  const std::vector<ReportGateView> views = evaluate_gate(gate(Gate::Over::each, 5), run).views;
  ASSERT_EQ(views.size(), 3u);
  EXPECT_EQ(views[1].view, "1");
  EXPECT_EQ(views[1].state, GateState::not_judged);
}

TEST(GateViews, NameTheVariantWhereTheGateHasAPattern) {
  Gate any = gate(Gate::Over::each, 20);
  any.variant = "isr-*";
  EXPECT_EQ(evaluate_gate(any, kRun).views[0].variant, "isr-48");
}

TEST(GateName, StaysWhileTheBoundsChange) {
  EXPECT_EQ(gate_name(gate(Gate::Over::mean, 18)), "gain of isr-48, mean, min");
  EXPECT_EQ(gate_name(gate(Gate::Over::mean, 19)), gate_name(gate(Gate::Over::mean, 18)));
  EXPECT_NE(gate_name(gate(Gate::Over::each, 18)), gate_name(gate(Gate::Over::mean, 18)));
  EXPECT_NE(gate_name(gate(Gate::Over::mean, std::nullopt, 18)), gate_name(gate(Gate::Over::mean, 18)));
  Gate narrow = gate(Gate::Over::mean, 18, 20);
  narrow.reference = "povray";
  narrow.scene = "a";
  narrow.view = "1*";
  EXPECT_EQ(gate_name(narrow), "gain of isr-48 against povray, scene a, view 1*, mean, min, max");
}

TEST(GateName, IsUniqueInARun) {
  const std::vector<Gate> gates = {gate(Gate::Over::mean, 18), gate(Gate::Over::mean, 25)};
  const auto results = evaluate_gates(gates, kRun);
  EXPECT_EQ(results[0].name, "gain of isr-48, mean, min");
  EXPECT_EQ(results[1].name, "gain of isr-48, mean, min (2)");
}

TEST(Gate, UndefinedValueIsNotMetAndSaysWhy) {
  RunReport run = kRun;
  run.scores[0].metrics["gain"] = MetricValue::undefined("the baseline has no error");
  for (const auto over : {Gate::Over::each, Gate::Over::mean, Gate::Over::worst}) {
    const ReportGate result = evaluate_gate(gate(over, -1000), run);
    EXPECT_EQ(result.state, GateState::not_met);
    EXPECT_EQ(result.detail, "a/1 has no gain: the baseline has no error");
  }
}

TEST(Gate, NotANumberIsNotMet) {
  RunReport run = kRun;
  run.scores[1].metrics["gain"] = MetricValue::of(std::nan(""));
  for (const auto over : {Gate::Over::each, Gate::Over::mean, Gate::Over::worst})
    EXPECT_EQ(evaluate_gate(gate(over, -1000, 1000), run).state, GateState::not_met);
}

TEST(Gate, FailedTaskIsNotMetAndSaysWhy) {
  RunReport run = kRun;
  run.scores[2].outcome = Outcome::failed;
  run.scores[2].error = "killed by signal 9";
  const ReportGate result = evaluate_gate(gate(Gate::Over::mean, 0), run);
  EXPECT_EQ(result.state, GateState::not_met);
  EXPECT_THAT(result.detail, AllOf(HasSubstr("b/1"), HasSubstr("killed by signal 9")));
}

/// Two of the three scores were not asked for.
RunReport part_of_a_run() {
  RunReport run = kRun;
  for (const std::size_t i : {1, 2}) {
    run.scores[i].outcome = Outcome::skipped;
    run.scores[i].error = "not asked for";
  }
  return run;
}

TEST(GateOfAPart, IsNotJudgedThoughWhatIsThereIsFine) {
  for (const auto over : {Gate::Over::each, Gate::Over::mean, Gate::Over::worst}) {
    const ReportGate result = evaluate_gate(gate(over, 5), part_of_a_run());
    EXPECT_EQ(result.state, GateState::not_judged);
    EXPECT_THAT(result.detail, HasSubstr("measured on 1 of 3 views only"));
  }
}

TEST(GateOfAPart, IsNotMetWhereOneViewBreaksItsBound) {
  for (const auto over : {Gate::Over::each, Gate::Over::worst})
    EXPECT_EQ(evaluate_gate(gate(over, 15), part_of_a_run()).state, GateState::not_met);
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::mean, 15), part_of_a_run()).state, GateState::not_judged)
      << "the views that are missing may lift the mean";
}

TEST(GateOfAPart, IsJudgedByWhatIsThereInAPartialRun) {
  RunReport run = part_of_a_run();
  run.partial = true;
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::mean, 5), run).state, GateState::met);
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::mean, 15), run).state, GateState::not_met);
}

TEST(GateOfAPart, WithoutAnyScoreIsNotJudgedEvenInAPartialRun) {
  RunReport run = part_of_a_run();
  run.scores[0].outcome = Outcome::skipped;
  for (const bool partial : {false, true}) {
    run.partial = partial;
    const ReportGate result = evaluate_gate(gate(Gate::Over::each, 5), run);
    EXPECT_EQ(result.state, GateState::not_judged);
    EXPECT_EQ(result.detail, "none of 3 views was measured");
  }
}

TEST(GateOfAPart, IsNotMetWhereOneViewHasNoNumber) {
  RunReport run = part_of_a_run();
  run.scores[0].metrics["gain"] = MetricValue::undefined("the baseline has no error");
  for (const auto over : {Gate::Over::each, Gate::Over::mean, Gate::Over::worst})
    EXPECT_EQ(evaluate_gate(gate(over, 5), run).state, GateState::not_met);
}

TEST(GateOfAPart, NeedsAllVariantsThatItsPatternMatches) {
  Gate all = gate(Gate::Over::each, 5);
  all.variant = "isr-*";
  RunReport run = run_of({score("a/1", "isr-48", 10), score("a/1", "isr-24", 10)});
  run.scores[1].outcome = Outcome::skipped;
  const ReportGate result = evaluate_gate(all, run);
  EXPECT_EQ(result.state, GateState::not_judged);
  EXPECT_EQ(result.detail, "isr-24: none of 1 view was measured");
}

TEST(Gate, MetricThatWasNotComputedIsNotMet) {
  Gate of_luv = gate(Gate::Over::each, 0);
  of_luv.metric = "luv";
  EXPECT_EQ(evaluate_gate(of_luv, kRun).state, GateState::not_met);
}

TEST(Gate, NothingToLookAtIsNotMet) {
  Gate nowhere = gate(Gate::Over::each, 0);
  nowhere.scene = "no such scene";
  const ReportGate result = evaluate_gate(nowhere, kRun);
  EXPECT_EQ(result.state, GateState::not_met);
  EXPECT_EQ(result.detail, "no score matches");
}

TEST(Gate, WithoutBoundsIsNotMet) {
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::each, std::nullopt), kRun).state, GateState::not_met);
}

TEST(Gate, PatternsChooseScenesAndViews) {
  Gate only = gate(Gate::Over::each, 10);
  only.scene = "a*";
  EXPECT_EQ(evaluate_gate(only, kRun).state, GateState::met);
  only.view = "2";
  only.min = 40;
  EXPECT_EQ(evaluate_gate(only, kRun).state, GateState::met);
}

TEST(Gate, PatternOfVariantsMustHoldForEach) {
  Gate all = gate(Gate::Over::mean, 5);
  all.variant = "isr-*";
  const RunReport run =
      run_of({score("a/1", "isr-48", 10), score("a/1", "isr-24", 1), score("a/1", "direct", 0)});
  const ReportGate result = evaluate_gate(all, run);
  EXPECT_EQ(result.state, GateState::not_met);
  EXPECT_EQ(result.detail, "isr-24: 1 mean of 1 view, below 5");
}

TEST(Gate, LooksAtThePrimaryReferenceUnlessItNamesOne) {
  RunReport run = kRun;
  run.scores.push_back(score("a/1", "isr-48", -50));
  run.scores.back().reference = "path";
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::each, 0), run).state, GateState::met);
  Gate against_path = gate(Gate::Over::each, 0);
  against_path.reference = "path";
  EXPECT_EQ(evaluate_gate(against_path, run).state, GateState::not_met);
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

/// The same scores with errors, of a baseline error of 10, against references of a known noise.
RunReport noisy_run(double noise) {
  RunReport run = run_of({});
  run.baseline = "direct";
  for (const auto& [view, gain] : {std::pair("a/1", 10.0), std::pair("a/2", 40.0)}) {
    run.scores.push_back(score(view, "direct", 0));
    run.scores.back().metrics["mean_error"] = MetricValue::of(10);
    run.scores.push_back(score(view, "isr-48", gain));
    run.scores.back().metrics["mean_error"] = MetricValue::of(10 - gain / 10);
    ReportImage reference;
    reference.scene = run.scores.back().scene;
    reference.view = run.scores.back().view;
    reference.source = "povray";
    reference.is_reference = true;
    reference.noise = noise;
    run.images.push_back(reference);
  }
  return run;
}

TEST(GateWithNoise, AGainOfLessThanTheNoiseIsAWarning) {
  const ReportGate result = evaluate_gate(gate(Gate::Over::each, 5), noisy_run(0.6));
  EXPECT_EQ(result.state, GateState::within_noise);
  EXPECT_THAT(result.detail, HasSubstr("a/1 by 0.5 of 255, less than the reference's noise of 0.6"));
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::each, 5), noisy_run(0.4)).state, GateState::met);
}

TEST(GateWithNoise, AMeanIsComparedWithTheMeanNoise) {
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::mean, 20), noisy_run(0.6)).state, GateState::within_noise);
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::mean, 18), noisy_run(0.6)).state, GateState::met);
}

TEST(GateWithNoise, AnErrorIsComparedAsItIs) {
  Gate of_error = gate(Gate::Over::worst, std::nullopt, 9.2);
  of_error.metric = "mean_error";
  EXPECT_EQ(evaluate_gate(of_error, noisy_run(0.3)).state, GateState::within_noise);
  EXPECT_EQ(evaluate_gate(of_error, noisy_run(0.1)).state, GateState::met);
}

TEST(GateWithNoise, DoesNotExcuseAGateThatIsNotMet) {
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::each, 10.1), noisy_run(50)).state, GateState::not_met);
}

TEST(GateWithNoise, TakesNoPartWhereItIsNotKnown) {
  RunReport run = noisy_run(50);
  for (ReportImage& image : run.images) image.noise.reset();
  EXPECT_EQ(evaluate_gate(gate(Gate::Over::each, 5), run).state, GateState::met);
}

}  // namespace
}  // namespace lightbench
