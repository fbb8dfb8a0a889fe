#include <set>

#include <gmock/gmock.h>

#include "job_fixture.h"
#include "pipeline/plan.h"
#include "pipeline/selection.h"

/// How techniques that draw what was baked are planned.
namespace lightbench {
namespace {

using test::concrete_job;
using test::facts_for;
using test::kJobText;
using test::replaced;
using test::task_called;
using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

/// The fixture's job with these variants, of two objects in each scene.
Plan plan_with(const std::string& variants, double texels = 100) {
  const Job job = concrete_job(replaced(kJobText, R"({"name": "other", "technique": "ambient"})", variants));
  PlanFacts facts = facts_for(job);
  for (SceneFacts& scene : facts.scenes) {
    scene.objects = {{0, "floor", "0000-floor"}, {2, "box", "0002-box"}};
    scene.sizes.assign(job.variants.size(), {{texels, 400}, {3 * texels, 400}});
  }
  return make_plan(job, facts, "/out");
}

std::string variant(const std::string& name, const std::string& params) {
  return R"({"name": ")" + name + R"(", "technique": "surface_radiance", "params": {)" + params + "}}";
}

std::vector<std::string> ids_of(const Plan& plan, TaskKind kind, int scene = 0) {
  std::vector<std::string> ids;
  for (const Task& task : plan.tasks)
    if (task.kind == kind && task.scene == scene) ids.push_back(task.id);
  return ids;
}

std::vector<std::string> dep_ids(const Plan& plan, const std::string& id) {
  std::vector<std::string> ids;
  for (const std::size_t dep : task_called(plan, id).deps) ids.push_back(plan.tasks[dep].id);
  return ids;
}

TEST(PlanBakes, EachObjectIsBakedOnceForAllViews) {
  const Plan plan = plan_with(variant("raw", ""));
  EXPECT_THAT(ids_of(plan, TaskKind::bake), ElementsAre("bake:one/raw/0000-floor", "bake:one/raw/0002-box"));
  for (const char* view : {"a", "b"})
    EXPECT_THAT(dep_ids(plan, std::string("snapshot:one/") + view + "/raw"),
                ElementsAre("bake:one/raw/0000-floor", "bake:one/raw/0002-box"));
  EXPECT_TRUE(ids_of(plan, TaskKind::compress).empty()) << "it draws what was baked as it is";
  EXPECT_EQ(task_called(plan, "bake:one/raw/0002-box").object, 2);
}

TEST(PlanBakes, VariantsThatBakeAlikeShareTheBake) {
  const Plan plan = plan_with(variant("raw", "") + "," + variant("six", R"("codec": "piecewise")"));
  EXPECT_THAT(ids_of(plan, TaskKind::bake), ElementsAre("bake:one/raw/0000-floor", "bake:one/raw/0002-box"));
  EXPECT_THAT(dep_ids(plan, "compress:one/six/0002-box"), ElementsAre("bake:one/raw/0002-box"));
  EXPECT_THAT(dep_ids(plan, "snapshot:one/a/six"),
              ElementsAre("compress:one/six/0000-floor", "compress:one/six/0002-box"));
}

TEST(PlanBakes, HowItIsDrawnChangesNoFiles) {
  const Plan plan = plan_with(variant("six", R"("codec": "piecewise")") + "," +
                              variant("binary", R"("codec": "piecewise", "search": "binary")"));
  EXPECT_THAT(ids_of(plan, TaskKind::compress),
              ElementsAre("compress:one/six/0000-floor", "compress:one/six/0002-box"));
}

TEST(PlanBakes, OtherDirectionsAndOtherThresholdsAreOtherFiles) {
  const Plan plan = plan_with(variant("six", R"("codec": "piecewise")") + "," +
                              variant("nine", R"("codec": "piecewise", "threshold": 9)") + "," +
                              variant("coarse", R"("codec": "piecewise", "thetas": 10)"));
  EXPECT_EQ(ids_of(plan, TaskKind::bake).size(), 4u);
  EXPECT_EQ(ids_of(plan, TaskKind::compress).size(), 6u);
  EXPECT_NE(task_called(plan, "compress:one/six/0000-floor").outputs,
            task_called(plan, "compress:one/nine/0000-floor").outputs);
}

TEST(PlanBakes, AnotherBoundIsAnotherFile) {
  const Plan plan =
      plan_with(variant("free", R"("codec": "pca")") + "," + variant("six", R"("codec": "pca", "bound": 6)") +
                "," + variant("nine", R"("codec": "pca", "bound": 9)"));
  EXPECT_EQ(ids_of(plan, TaskKind::compress).size(), 6u);
  std::set<std::string> keys;
  for (const char* name : {"free", "six", "nine"})
    keys.insert(task_called(plan, std::string("compress:one/") + name + "/0000-floor").key);
  EXPECT_EQ(keys.size(), 3u);
}

TEST(PlanBakes, BelongToTheStageOfSnapshots) {
  const Plan plan = plan_with(variant("six", R"("codec": "piecewise")"));
  const std::vector<bool> selected = select_tasks(plan, {TaskKind::snapshot}, "one/a/six");
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < selected.size(); ++i)
    if (selected[i]) ids.push_back(plan.tasks[i].id);
  EXPECT_THAT(ids, UnorderedElementsAre("bake:one/six/0000-floor", "bake:one/six/0002-box",
                                        "compress:one/six/0000-floor", "compress:one/six/0002-box",
                                        "snapshot:one/a/six"));
}

TEST(PlanBakes, OtherTechniquesBakeNothing) {
  const Plan plan = plan_with(variant("raw", ""));
  EXPECT_TRUE(dep_ids(plan, "snapshot:one/a/direct").empty());
}

TEST(PlanBakes, AnotherBakeIsAnotherSnapshot) {
  const std::string id = "snapshot:one/a/raw";
  EXPECT_NE(task_called(plan_with(variant("raw", "")), id).key,
            task_called(plan_with(variant("raw", R"("seed": 2)")), id).key);
}

TEST(PlanBakes, NoSizeIsTooLargeToBePlanned) {
  const Plan plan = plan_with(variant("six", R"("codec": "piecewise")"), 1e18);
  for (const Task& task : plan.tasks) EXPECT_GT(task.resources.memory_mb, 0) << task.id;
  EXPECT_GE(task_called(plan, "bake:one/six/0000-floor").resources.memory_mb, 1'000'000'000);
}

}  // namespace
}  // namespace lightbench
