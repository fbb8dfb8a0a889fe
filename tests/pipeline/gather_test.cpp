#include "pipeline/gather.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "job_fixture.h"
#include "pipeline/selection.h"
#include "reports/reference_facts.h"

namespace lightbench {
namespace {

using test::index_of;
using test::replaced;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Gather : public ::testing::Test {
 protected:
  Gather() {
    for (const auto& task : plan_.tasks) {
      TaskOutcome outcome;
      outcome.state = TaskState::done;
      outcome.entry = LedgerEntry{};
      if (task.kind == TaskKind::score) outcome.entry->result.metrics["gain"] = MetricValue::of(30);
      outcomes_.push_back(outcome);
    }
  }

  TaskOutcome& outcome(const std::string& id) { return outcomes_[index_of(plan_, id)]; }
  void set(const std::string& id, TaskState state, const std::string& reason) {
    outcome(id) = {state, reason, 0, std::nullopt};
  }
  RunReport report() const { return gather_report(plan_, test::facts_for(plan_.job), outcomes_, scope_); }
  static const ReportImage& image(const RunReport& report, const std::string& scene, const std::string& view,
                                  const std::string& source) {
    for (const auto& i : report.images)
      if (i.scene == scene && i.view == view && i.source == source) return i;
    throw std::out_of_range(source);
  }

  Plan plan_ = test::plan_of(test::concrete_job(
      replaced(test::kJobText, R"("metrics")",
               R"("gates": [{"metric": "gain", "variant": "other", "min": 25}], "metrics")")));
  std::vector<TaskOutcome> outcomes_;
  std::vector<bool> selected_;
  GateScope scope_ = GateScope::all_scores;
};

TEST_F(Gather, EveryImageAndScoreStandsInTheReportOnce) {
  const RunReport made = report();
  EXPECT_EQ(made.images.size(), 9u);
  EXPECT_EQ(made.scores.size(), 6u);
  EXPECT_EQ(made.scenes.size(), 2u);
  EXPECT_EQ(exit_code_of(made, outcomes_, selected_), ExitCode::ok);
}

TEST_F(Gather, PathsAreRelativeToTheRunsFolder) {
  const RunReport made = report();
  EXPECT_EQ(image(made, "one", "a", "other").png, "views/one/a/other.png");
  EXPECT_EQ(made.scores[0].difference_png, "views/one/a/direct~truth.diff.png");
  EXPECT_EQ(made.scores[1].baseline_difference_png, "views/one/a/other~direct.diff.png");
}

TEST_F(Gather, AFailureIsARowWithItsMessage) {
  set("snapshot:one/a/other", TaskState::failed, "no light");
  set("score:one/a/other/truth", TaskState::skipped, "needs snapshot:one/a/other, which failed");
  const RunReport made = report();
  EXPECT_EQ(image(made, "one", "a", "other").outcome, Outcome::failed);
  EXPECT_EQ(image(made, "one", "a", "other").error, "no light");
  EXPECT_EQ(made.scores[1].outcome, Outcome::skipped);
  EXPECT_EQ(exit_code_of(made, outcomes_, selected_), ExitCode::task_failed);
}

TEST_F(Gather, AFailedExportIsAFailedReference) {
  set("export:two/povray", TaskState::failed, "disk full");
  set("reference:two/a/truth", TaskState::skipped, "needs export:two/povray, which failed: disk full");
  const RunReport made = report();
  EXPECT_EQ(image(made, "two", "a", "truth").outcome, Outcome::failed);
  EXPECT_THAT(image(made, "two", "a", "truth").error, HasSubstr("disk full"));
}

TEST_F(Gather, AGateThatIsNotMetDecides) {
  outcome("score:one/b/other/truth").entry->result.metrics["gain"] = MetricValue::of(24.9);
  const RunReport made = report();
  ASSERT_EQ(made.gates.size(), 1u);
  EXPECT_EQ(made.gates[0].state, GateState::not_met);
  EXPECT_EQ(exit_code_of(made, outcomes_, selected_), ExitCode::gate_failed);
}

TEST_F(Gather, AFailureCountsMoreThanAGate) {
  set("score:one/b/other/truth", TaskState::failed, "sizes differ");
  EXPECT_EQ(exit_code_of(report(), outcomes_, selected_), ExitCode::task_failed);
}

TEST_F(Gather, AGateThatLacksAScoreIsNotJudged) {
  selected_ = select_tasks(plan_, {}, "one/*");
  set("score:two/a/other/truth", TaskState::skipped, "not asked for");
  const RunReport made = report();
  ASSERT_EQ(made.gates.size(), 1u);
  EXPECT_EQ(made.gates[0].state, GateState::not_judged);
  EXPECT_THAT(made.gates[0].detail, HasSubstr("measured on 2 of 3 views only"));
  EXPECT_EQ(exit_code_of(made, outcomes_, selected_), ExitCode::not_judged);
}

TEST_F(Gather, APartialRunIsJudgedByWhatIsThere) {
  scope_ = GateScope::what_is_there;
  selected_ = select_tasks(plan_, {}, "one/*");
  set("score:two/a/other/truth", TaskState::skipped, "not asked for");
  const RunReport made = report();
  EXPECT_EQ(made.gates.at(0).state, GateState::met);
  EXPECT_EQ(exit_code_of(made, outcomes_, selected_), ExitCode::ok);
}

TEST_F(Gather, AGateWithoutAnyScoreIsNotJudged) {
  selected_ = select_tasks(plan_, {TaskKind::snapshot}, "");
  for (std::size_t i = 0; i < outcomes_.size(); ++i)
    if (plan_.tasks[i].kind == TaskKind::score)
      outcomes_[i] = {TaskState::skipped, "not asked for", 0, std::nullopt};
  EXPECT_EQ(report().gates.at(0).state, GateState::not_judged);
  EXPECT_EQ(exit_code_of(report(), outcomes_, selected_), ExitCode::not_judged);
  scope_ = GateScope::what_is_there;
  EXPECT_EQ(report().gates.at(0).state, GateState::not_judged);
  EXPECT_EQ(exit_code_of(report(), outcomes_, selected_), ExitCode::ok) << "the user wanted a part";
}

TEST_F(Gather, AFailedPictureLeavesItsGateNotMet) {
  set("snapshot:one/a/other", TaskState::failed, "no light");
  set("score:one/a/other/truth", TaskState::skipped, "needs snapshot:one/a/other, which failed");
  const RunReport made = report();
  EXPECT_EQ(made.gates.at(0).state, GateState::not_met);
  EXPECT_THAT(made.gates.at(0).detail, HasSubstr("which failed"));
}

TEST_F(Gather, AStoredReportHasTheSameExitCode) {
  set("score:two/a/other/truth", TaskState::skipped, "not asked for");
  const RunReport made = report();
  const RunReport stored = run_report_from_json(run_report_to_json(made), "run.json");
  EXPECT_EQ(exit_code_of(stored), ExitCode::not_judged);
  scope_ = GateScope::what_is_there;
  EXPECT_EQ(exit_code_of(run_report_from_json(run_report_to_json(report()), "run.json")), ExitCode::ok);
}

TEST_F(Gather, AScoreTellsWhatItsTaskWarnedOf) {
  outcome("score:one/a/other/truth").entry->result.warnings = {"the pictures are identical"};
  outcome("score:one/b/other/truth").entry->result.warnings = {"the pictures are identical"};
  const RunReport made = report();
  EXPECT_THAT(made.scores[1].warnings, Contains("the pictures are identical"));
}

TEST_F(Gather, PicturesOfAnotherEngineHaveNoCostAndNoBounces) {
  plan_ = test::plan_of(test::concrete_job(
      replaced(test::kJobText, R"({"name": "other", "technique": "ambient"})",
               R"({"name": "other", "technique": "images", "params": {"pattern": "{scene}/{view}.png"}})")));
  ASSERT_EQ(plan_.tasks.size(), outcomes_.size());
  TaskResult& result = outcome("snapshot:one/a/other").entry->result;
  result.seconds = result.cpu_seconds = 0.002;
  result.passes = {{"read", 0.002}};
  const RunReport made = report();
  EXPECT_EQ(image(made, "one", "a", "other").seconds, 0);
  EXPECT_EQ(image(made, "one", "a", "other").cpu_seconds, 0);
  EXPECT_TRUE(image(made, "one", "a", "other").passes.empty());
  EXPECT_THAT(bounces_lines(made),
              ElementsAre("truth has 2 bounces of indirect light; other numbers: direct 0"));
}

TEST_F(Gather, WhatTheSceneLacksIsToldWithIt) {
  PlanFacts facts = test::facts_for(plan_.job);
  facts.scenes[0].warnings = {"bump maps are ignored"};
  facts.scenes[0].kind_warnings["povray"] = {"a light is approximated"};
  facts.scenes[0].credits = {{"chair", "someone", "CC0"}};
  const RunReport made = gather_report(plan_, facts, outcomes_, scope_);
  EXPECT_THAT(made.scenes[0].warnings,
              ElementsAre("bump maps are ignored", "povray: a light is approximated"));
  EXPECT_EQ(made.scenes[0].credits.at(0).creator, "someone");
}

/// Two objects in scene "one" (and "two"), drawn as they are baked, and in two ways from the same compressed
/// files.
class GatherObjects : public ::testing::Test {
 protected:
  static constexpr const char* kVariants = R"(
      {"name": "raw", "technique": "surface_radiance"},
      {"name": "six", "technique": "surface_radiance", "params": {"codec": "piecewise"}},
      {"name": "binary", "technique": "surface_radiance", "params": {"codec": "piecewise", "search": "binary"}})";

  GatherObjects() {
    for (SceneFacts& scene : facts_.scenes) {
      scene.objects = {{0, "the/floor", "0000-floor"}, {2, "box", "0002-box"}};
      scene.sizes.assign(job_.variants.size(), {{100, 400}, {300, 400}});
    }
    plan_ = make_plan(job_, facts_, "/out");
    outcomes_.assign(plan_.tasks.size(), {TaskState::done, "", 0, LedgerEntry{}});
  }
  TaskOutcome& outcome(const std::string& id) { return outcomes_[index_of(plan_, id)]; }
  RunReport report() const { return gather_report(plan_, facts_, outcomes_, GateScope::all_scores); }

  Job job_ =
      test::concrete_job(replaced(test::kJobText, R"({"name": "other", "technique": "ambient"})", kVariants));
  PlanFacts facts_ = test::facts_for(job_);
  Plan plan_;
  std::vector<TaskOutcome> outcomes_;
};

TEST_F(GatherObjects, EachStandsInTheReportOnceWithAllVariantsThatDrawIt) {
  const RunReport made = report();
  ASSERT_EQ(made.bakes.size(), 4u);
  EXPECT_EQ(made.bakes[0].scene, "one");
  EXPECT_EQ(made.bakes[0].object, "the/floor");
  EXPECT_EQ(made.bakes[1].object, "box");
  EXPECT_EQ(made.bakes[2].scene, "two");
  EXPECT_THAT(made.bakes[0].variants, ElementsAre("raw", "six", "binary"));
  ASSERT_EQ(made.compressions.size(), 4u);
  EXPECT_THAT(made.compressions[0].variants, ElementsAre("six", "binary"));
}

TEST_F(GatherObjects, TellWhatTheirTasksTold) {
  TaskOutcome& box = outcome("bake:one/raw/0002-box");
  box.state = TaskState::cached;
  box.entry->result.cpu_seconds = 2.5;
  box.entry->result.noise = 0.25;
  box.entry->result.ray_rates["shadow"] = 1e6;
  outcome("compress:one/six/0002-box").entry->result.metrics["ratio"] = MetricValue::of(12);
  const RunReport made = report();
  EXPECT_TRUE(made.bakes[1].cached);
  EXPECT_EQ(made.bakes[1].cpu_seconds, 2.5);
  EXPECT_EQ(made.bakes[1].noise, 0.25);
  EXPECT_EQ(made.bakes[1].ray_rates.at("shadow"), 1e6);
  EXPECT_EQ(made.compressions[1].numbers.at("ratio"), MetricValue::of(12));
}

TEST_F(GatherObjects, WhatNeedsAFailedBakeHasFailedToo) {
  outcome("bake:one/raw/0002-box") = {TaskState::failed, "no texels", 0, std::nullopt};
  outcome("compress:one/six/0002-box") = {TaskState::skipped, "needs the bake, which failed", 0,
                                          std::nullopt};
  outcome("snapshot:one/a/six") = {TaskState::skipped, "needs the compression", 0, std::nullopt};
  const RunReport made = report();
  EXPECT_EQ(made.bakes[1].error, "no texels");
  EXPECT_EQ(made.bakes[0].outcome, Outcome::ok);
  EXPECT_EQ(made.compressions[1].outcome, Outcome::failed);
  const auto six = std::ranges::find(made.images, "six", &ReportImage::source);
  EXPECT_EQ(six->outcome, Outcome::failed);
}

TEST_F(GatherObjects, AFailedOneDecidesTheExitCodeOfAStoredReport) {
  RunReport made;
  made.compressions.emplace_back().outcome = Outcome::failed;
  EXPECT_EQ(exit_code_of(made), ExitCode::task_failed);
}

TEST(GatherSequences, FramesStandInTheirOrderWithTheirTimes) {
  auto text = replaced(test::kJobText, R"("scene": "one.json",)",
                       R"("scene": "one.json", "sequence": {"start": 3, "frames": 2, "rate": 4},)");
  // A sequence that a script wrote out, last frame first.
  text = replaced(
      text, R"({"name": "a", "position": [1, 0, 0], "look_at": [0, 0, 0]})",
      R"({"name": "late", "position": [1, 0, 0], "look_at": [0, 0, 0], "time": 7, "frame": {"of": "x", "number": 1}},
                     {"name": "early", "position": [1, 0, 0], "look_at": [0, 0, 0], "frame": {"of": "x", "number": 0}})");
  const Plan plan = test::plan_of(test::concrete_job(text));
  const RunReport made = gather_report(plan, test::facts_for(plan.job),
                                       std::vector<TaskOutcome>(plan.tasks.size()), GateScope::all_scores);
  ASSERT_EQ(made.sequences.size(), 3u);
  EXPECT_EQ(made.sequences[1].scene, "one");
  EXPECT_EQ(made.sequences[1].name, "b");
  EXPECT_EQ(made.sequences[1].frames[1].view, "b.001");
  EXPECT_EQ(made.sequences[1].frames[1].time, 3.25);
  EXPECT_EQ(made.sequences[2].frames[0].view, "early");
  EXPECT_EQ(made.sequences[2].frames[1].view, "late");
}

}  // namespace
}  // namespace lightbench
