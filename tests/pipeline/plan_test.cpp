#include "pipeline/plan.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/files.h"
#include "job_fixture.h"
#include "pipeline/plan_file.h"

namespace lightbench {
namespace {

using test::concrete_job;
using test::facts_for;
using test::kJobText;
using test::plan_of;
using test::replaced;
using test::task_called;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// Ids of the tasks whose key differs between two plans of the same tasks.
std::set<std::string> changed_tasks(const Plan& before, const Plan& after) {
  std::set<std::string> ids;
  for (std::size_t i = 0; i < before.tasks.size(); ++i)
    if (before.tasks[i].key != after.tasks[i].key) ids.insert(before.tasks[i].id);
  return ids;
}

std::vector<std::string> dep_ids(const Plan& plan, const Task& task) {
  std::vector<std::string> ids;
  for (const std::size_t dep : task.deps) ids.push_back(plan.tasks[dep].id);
  return ids;
}

TEST(Plan, HasATaskForEachStep) {
  const Plan plan = plan_of(concrete_job());
  std::map<TaskKind, int> counts;
  for (const auto& task : plan.tasks) ++counts[task.kind];
  EXPECT_EQ(counts[TaskKind::snapshot], 6);  // 3 views x 2 variants
  EXPECT_EQ(counts[TaskKind::reference], 3);
  EXPECT_EQ(counts[TaskKind::export_], 5);  // one for each view, one for each scene
  EXPECT_EQ(counts[TaskKind::score], 6);
}

TEST(Plan, IdsAreUnique) {
  std::set<std::string> ids;
  const Plan plan = plan_of(concrete_job());
  for (const auto& task : plan.tasks) EXPECT_TRUE(ids.insert(task.id).second) << task.id;
}

TEST(Plan, DependenciesStandBeforeThoseThatNeedThem) {
  const Plan plan = plan_of(concrete_job());
  for (std::size_t i = 0; i < plan.tasks.size(); ++i)
    for (const std::size_t dep : plan.tasks[i].deps) EXPECT_LT(dep, i);
}

TEST(Plan, AScoreNeedsItsPicturesAndTheBaselines) {
  const Plan plan = plan_of(concrete_job());
  EXPECT_THAT(dep_ids(plan, task_called(plan, "score:one/a/other/truth")),
              ElementsAre("snapshot:one/a/other", "reference:one/a/truth", "snapshot:one/a/direct"));
  EXPECT_THAT(dep_ids(plan, task_called(plan, "score:one/a/direct/truth")),
              ElementsAre("snapshot:one/a/direct", "reference:one/a/truth"));
}

TEST(Plan, AReferenceNeedsItsExports) {
  const Plan plan = plan_of(concrete_job());
  EXPECT_THAT(dep_ids(plan, task_called(plan, "reference:one/b/truth")),
              ElementsAre("export:one/povray", "export:one/b/truth"));
}

TEST(Plan, OutputsStandInTheFolderOfTheirView) {
  const Plan plan = plan_of(concrete_job());
  EXPECT_THAT(task_called(plan, "snapshot:one/a/other").outputs,
              ElementsAre("views/one/a/other.exr", "views/one/a/other.png"));
  EXPECT_THAT(task_called(plan, "score:one/a/other/truth").outputs,
              UnorderedElementsAre("views/one/a/other~truth.score.json", "views/one/a/other~truth.diff.png",
                                   "views/one/a/other~truth.heat.png", "views/one/a/other~direct.diff.png"));
}

TEST(Plan, NoTwoTasksWriteOneFile) {
  auto text = replaced(kJobText, R"("metrics")", R"("buffers": ["albedo", "depth"], "metrics")");
  text = replaced(text, R"("variants": [)",
                  R"("variants": [{"name": "other~truth.diff", "technique": "ambient"},
                                  {"name": "other~~albedo", "technique": "ambient"},
                                  {"name": "other%7Etruth", "technique": "ambient"},)");
  const Plan plan = plan_of(concrete_job(text));
  std::set<std::string> files;
  for (const auto& task : plan.tasks)
    for (const auto& file : task.outputs) EXPECT_TRUE(files.insert(file).second) << file;
}

TEST(Plan, NamesThatAreNoFileNamesAreEscaped) {
  const Plan plan =
      plan_of(concrete_job(replaced(kJobText, R"("name": "other")", R"("name": "../o ther~x")")));
  for (const auto& task : plan.tasks) {
    EXPECT_EQ(task.id.find(' '), std::string::npos) << task.id;
    for (const auto& file : task.outputs) EXPECT_EQ(file.find("../"), std::string::npos) << file;
  }
}

/// All components of the paths that a plan writes.
std::set<std::string> components(const Plan& plan) {
  std::set<std::string> names;
  for (const auto& task : plan.tasks)
    for (const auto& file : task.outputs)
      for (const auto& component : std::filesystem::path(file)) names.insert(component.string());
  return names;
}

RC_GTEST_PROP(Plan, NoNameMakesAFileNameTooLong, ()) {
  const auto text = rc::gen::resize(
      200, rc::gen::container<std::string>(rc::gen::element('~', 'a', '.', ' ', '%', '/', '\xc3')));
  Job job = concrete_job();
  job.variants[1].name = *text;
  job.references[0].name = *text + "r";
  job.scenes[0].name = *text;
  for (const auto& name : components(plan_of(job))) RC_ASSERT(name.size() <= 255u);
}

RC_GTEST_PROP(Plan, DifferentNamesGiveDifferentFiles, ()) {
  const auto text =
      rc::gen::resize(200, rc::gen::container<std::string>(rc::gen::element('~', 'a', '%', '7', 'E')));
  const std::string one = *text, other = *text;
  const Job job = concrete_job();
  RC_ASSERT((one == other) == (image_stem(job, 0, 0, one) == image_stem(job, 0, 0, other)));
  RC_ASSERT(score_stem(job, 0, 0, one, other) != image_stem(job, 0, 0, one));
}

TEST(Plan, TheLongestFileNameCanBeWritten) {
  const TemporaryFolder folder;
  const std::string name(200, '~');
  const std::string stem = score_stem(concrete_job(), 0, 0, name, name + "~");
  EXPECT_NO_THROW(write_file_atomic(folder.path() / (stem + ".score.json"), "x"));
}

TEST(Plan, NamesWithoutTildesKeepTheirFileNames) {
  EXPECT_EQ(score_stem(concrete_job(), 0, 0, "isr-48[radius=0.5]", "POV-Ray 3"),
            "views/one/a/isr-48[radius=0.5]~POV-Ray%203");
  EXPECT_EQ(image_stem(concrete_job(), 0, 0, "a~b"), "views/one/a/a%7Eb");
}

TEST(Plan, EqualInputGivesAnEqualPlan) {
  EXPECT_EQ(plan_to_json(plan_of(concrete_job())), plan_to_json(plan_of(concrete_job())));
}

TEST(Plan, TheOutputFolderIsNoPartOfKeys) {
  const Job job = concrete_job();
  EXPECT_THAT(changed_tasks(plan_of(job), make_plan(job, facts_for(job), "/elsewhere")), IsEmpty());
}

TEST(PlanKey, AParameterChangesItsVariantAlone) {
  const Plan before = plan_of(concrete_job());
  const Plan after = plan_of(concrete_job(
      replaced(kJobText, R"("technique": "ambient")", R"("technique": "ambient", "params": {"k": 0.1})")));
  EXPECT_THAT(
      changed_tasks(before, after),
      UnorderedElementsAre("snapshot:one/a/other", "snapshot:one/b/other", "snapshot:two/a/other",
                           "score:one/a/other/truth", "score:one/b/other/truth", "score:two/a/other/truth"));
}

TEST(PlanKey, AViewChangesItselfAlone) {
  const Plan before = plan_of(concrete_job());
  const Job job = concrete_job(replaced(kJobText, "[0, 0, 2]", "[0, 0, 3]"));
  PlanFacts facts = facts_for(job);
  facts.scenes[0].exports[0][1][1].second = "another camera";
  EXPECT_THAT(
      changed_tasks(before, make_plan(job, facts, "/out")),
      UnorderedElementsAre("snapshot:one/b/direct", "snapshot:one/b/other", "export:one/b/truth",
                           "reference:one/b/truth", "score:one/b/direct/truth", "score:one/b/other/truth"));
}

TEST(PlanKey, ASceneFileChangesItsSnapshotsButNoReferenceWhoseExportIsTheSame) {
  const Job job = concrete_job();
  PlanFacts facts = facts_for(job);
  facts.scenes[1].files[0].second = "other bytes";
  EXPECT_THAT(changed_tasks(plan_of(job), make_plan(job, facts, "/out")),
              UnorderedElementsAre("snapshot:two/a/direct", "snapshot:two/a/other",
                                   "score:two/a/direct/truth", "score:two/a/other/truth"));
}

TEST(PlanKey, TheRendererChangesSnapshotsAndTheirScores) {
  const Job job = concrete_job();
  PlanFacts facts = facts_for(job);
  facts.renderer = "another renderer";
  for (const auto& id : changed_tasks(plan_of(job), make_plan(job, facts, "/out")))
    EXPECT_TRUE(id.starts_with("snapshot:") || id.starts_with("score:")) << id;
}

TEST(PlanKey, TheToolsVersionChangesReferencesAndScores) {
  const Job job = concrete_job();
  PlanFacts facts = facts_for(job);
  facts.tools["povray"] = "POV-Ray 3.8";
  const auto changed = changed_tasks(plan_of(job), make_plan(job, facts, "/out"));
  EXPECT_EQ(changed.size(), 9u);
  for (const auto& id : changed) EXPECT_TRUE(id.starts_with("reference:") || id.starts_with("score:")) << id;
}

TEST(PlanKey, MetricsChangeScoresAlone) {
  const auto changed = changed_tasks(
      plan_of(concrete_job()), plan_of(concrete_job(replaced(kJobText, R"("gain"])", R"("pearson"])"))));
  EXPECT_EQ(changed.size(), 6u);
  for (const auto& id : changed) EXPECT_TRUE(id.starts_with("score:")) << id;
}

TEST(Plan, ASceneThatCannotBeReadRefusesItsTasksAlone) {
  const Job job = concrete_job();
  PlanFacts facts = facts_for(job);
  facts.scenes[1] = SceneFacts();
  facts.scenes[1].error = "two.obj:3: nonsense";
  const Plan plan = make_plan(job, facts, "/out");
  for (const auto& task : plan.tasks)
    EXPECT_EQ(task.refused, task.scene == 1 ? "two.obj:3: nonsense" : "") << task.id;
}

TEST(Plan, AVariantThatCannotShowASceneSaysWhy) {
  const Job job = concrete_job();
  PlanFacts facts = facts_for(job);
  facts.scenes[0].unsupported = {{}, {"area lights", "water"}};
  const Plan plan = make_plan(job, facts, "/out");
  EXPECT_EQ(task_called(plan, "snapshot:one/a/other").refused, "area lights; water");
  EXPECT_EQ(task_called(plan, "snapshot:one/a/direct").refused, "");
}

Plan plan_with_reference(const std::string& reference) {
  return plan_of(concrete_job(replaced(kJobText, R"({"name": "truth", "kind": "povray"})", reference)));
}

TEST(PlanReferences, ThePathTracerRendersTheSceneItself) {
  const Plan plan = plan_with_reference(R"({"name": "truth", "kind": "path_tracer"})");
  for (const Task& task : plan.tasks) EXPECT_NE(task.kind, TaskKind::export_) << task.id;
  EXPECT_THAT(task_called(plan, "reference:one/a/truth").deps, IsEmpty());
}

TEST(PlanReferences, ThePathTracersKeyHasTheScenesFiles) {
  const Job job = concrete_job(replaced(kJobText, R"("kind": "povray")", R"("kind": "path_tracer")"));
  PlanFacts facts = facts_for(job);
  const Plan before = make_plan(job, facts, "/out");
  facts.scenes[1].files = {{"two.obj", "other bytes"}};
  const Plan after = make_plan(job, facts, "/out");
  EXPECT_TRUE(changed_tasks(before, after).contains("reference:two/a/truth"));
  EXPECT_FALSE(changed_tasks(before, after).contains("reference:one/a/truth"));
}

TEST(PlanReferences, AnEstimateOfNoiseExportsASecondView) {
  const Plan plan =
      plan_with_reference(R"({"name": "truth", "kind": "povray", "params": {"estimate_noise": true}})");
  EXPECT_THAT(task_called(plan, "export:one/a/truth").outputs,
              ElementsAre("views/one/a/truth.pov", "views/one/a/truth~~second.pov"));
  const Plan direct = plan_with_reference(
      R"({"name": "truth", "kind": "povray", "preset": "direct", "params": {"estimate_noise": true}})");
  EXPECT_THAT(task_called(direct, "export:one/a/truth").outputs, ElementsAre("views/one/a/truth.pov"));
}

Job sequence_job(const std::string& metrics) {
  auto text = replaced(kJobText, R"("scene": "one.json",)",
                       R"("scene": "one.json", "sequence": {"frames": 2, "rate": 2},)");
  return concrete_job(
      replaced(text, R"("metrics": ["mean_error", "gain"])", R"("metrics": [)" + metrics + "]"));
}

TEST(Plan, AScoreNeedsTheFrameBeforeWhereAMetricDoes) {
  const Plan plan = plan_of(sequence_job(R"("flicker")"));
  EXPECT_THAT(dep_ids(plan, task_called(plan, "score:one/b.001/direct/truth")),
              ElementsAre("snapshot:one/b.001/direct", "reference:one/b.001/truth",
                          "snapshot:one/b.000/direct", "reference:one/b.000/truth"));
  EXPECT_THAT(dep_ids(plan, task_called(plan, "score:one/b.000/direct/truth")),
              ElementsAre("snapshot:one/b.000/direct", "reference:one/b.000/truth"));
}

TEST(Plan, NoOtherMetricLooksAtTheFrameBefore) {
  const Plan plan = plan_of(sequence_job(R"("mean_error")"));
  EXPECT_THAT(dep_ids(plan, task_called(plan, "score:one/b.001/direct/truth")),
              ElementsAre("snapshot:one/b.001/direct", "reference:one/b.001/truth"));
}

TEST(Plan, TheTimeIsPartOfKeysOnlyWhereTheSceneMoves) {
  const Job job = sequence_job(R"("mean_error")");
  PlanFacts facts = facts_for(job);
  const auto keys = [&](const std::string& frame) {
    return task_called(make_plan(job, facts, "/out"), "snapshot:one/a." + frame + "/direct").key;
  };
  EXPECT_EQ(keys("000"), keys("001")) << "the camera stands still too";
  facts.scenes[0].moves = true;
  EXPECT_NE(keys("000"), keys("001"));
}

TEST(Plan, TexturesCountInTheMemoryOfWhatHoldsThem) {
  const Job job = concrete_job();
  PlanFacts facts = facts_for(job);
  const auto memory = [&](const std::string& id) {
    return task_called(make_plan(job, facts, "/out"), id).resources.memory_mb;
  };
  const int drawn = memory("snapshot:one/a/direct"), exported = memory("export:one/povray");
  facts.scenes[0].texture_bytes = 1'000'000'000;
  EXPECT_EQ(memory("snapshot:one/a/direct"), drawn + 3000);
  EXPECT_EQ(memory("export:one/povray"), exported + 2000);
  facts.scenes[0].texture_bytes = std::size_t(1) << 62;
  EXPECT_GT(memory("snapshot:one/a/direct"), 0) << "more than the number holds";
}

TEST(Plan, ManyShadowMapsAreExpectedToTakeLonger) {
  const Job job =
      concrete_job(replaced(kJobText, R"({"name": "other", "technique": "ambient"})",
                            R"({"name": "other", "technique": "direct", "params": {"shadows": "none"}})"));
  PlanFacts facts = facts_for(job);
  facts.scenes[0].light_points = 100000;
  const Plan plan = make_plan(job, facts, "/out");
  const Task& shadows = task_called(plan, "snapshot:one/a/direct");
  const Task& none = task_called(plan, "snapshot:one/a/other");
  EXPECT_GT(shadows.expected_seconds, 1000);
  EXPECT_LT(none.expected_seconds, 1);
  EXPECT_GT(shadows.timeout_seconds, shadows.expected_seconds);
  EXPECT_LT(none.timeout_seconds, shadows.timeout_seconds);
}

}  // namespace
}  // namespace lightbench
