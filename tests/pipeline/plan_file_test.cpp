#include "pipeline/plan_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "job_fixture.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

std::string error_of(const std::string& text) {
  const TemporaryFolder folder;
  write_file_atomic(folder.path() / "plan.json", text);
  try {
    read_plan(folder.path() / "plan.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(PlanFile, ReadsBackToTheSamePlan) {
  const TemporaryFolder folder;
  const std::string text = plan_to_json(test::plan_of(test::concrete_job()));
  write_file_atomic(folder.path() / "plan.json", text);
  EXPECT_EQ(plan_to_json(read_plan(folder.path() / "plan.json")), text);
}

TEST(PlanFile, PathsKeepTheirBytes) {
  const TemporaryFolder folder;
  Plan plan = test::plan_of(test::concrete_job());
  plan.out = "/out\xE9";
  plan.job.file = "/jobs\xE9/job.json";
  plan.job.scenes[0].file = "/jobs\xE9/caf\xE9.json";
  plan.tasks[0].key_parts = {{"file caf\xE9.png", "hash"}};
  write_file_atomic(folder.path() / "plan.json", plan_to_json(plan));
  const Plan read = read_plan(folder.path() / "plan.json");
  EXPECT_EQ(read.out, plan.out);
  EXPECT_EQ(read.job.file, plan.job.file);
  EXPECT_EQ(read.job.scenes[0].file, plan.job.scenes[0].file);
  EXPECT_EQ(read.tasks[0].key_parts, plan.tasks[0].key_parts);
}

TEST(PlanFile, AnotherVersionIsRefused) {
  const std::string text = plan_to_json(test::plan_of(test::concrete_job()));
  EXPECT_THAT(
      error_of(test::replaced(text, fmt::format("\"format\": {}", kPlanFormatVersion), "\"format\": 999")),
      HasSubstr("another version"));
}

TEST(PlanFile, WhatIsNoPlanIsRefused) {
  EXPECT_THAT(error_of("{}"), HasSubstr("plan.json: $: the key 'format' is missing"));
  EXPECT_THAT(error_of("{\"format\": 2, "), HasSubstr("plan.json:1"));
  EXPECT_THAT(error_of("{\"format\": 2}"), HasSubstr("the key 'out' is missing"));
}

/// What reading a plan says when one of its task's keys has another value.
std::string error_with(TaskKind kind, const std::string& key, const nlohmann::json& value) {
  auto json = nlohmann::ordered_json::parse(plan_to_json(test::plan_of(test::concrete_job())));
  for (auto& task : json["tasks"])
    if (task["kind"] == to_text(kind)) {
      task[key] = value;
      break;
    }
  return error_of(json.dump());
}

TEST(PlanFile, AnIndexThatPointsNowhereIsRefused) {
  for (const int bad : {-2, 2, 1000000})
    EXPECT_THAT(error_with(TaskKind::snapshot, "scene", bad), HasSubstr(".scene: must be between 0 and 1"));
  EXPECT_THAT(error_with(TaskKind::snapshot, "view", -1), HasSubstr(".view: must be between 0 and 1"));
  EXPECT_THAT(error_with(TaskKind::reference, "view", 2), HasSubstr(".view: must be between 0 and 1"));
  EXPECT_THAT(error_with(TaskKind::snapshot, "variant", 2), HasSubstr(".variant: must be between 0 and 1"));
  EXPECT_THAT(error_with(TaskKind::reference, "variant", 7), HasSubstr(".variant: must be between -1 and 1"));
  EXPECT_THAT(error_with(TaskKind::export_, "reference", -1),
              HasSubstr(".reference: must be between 0 and 0"));
  EXPECT_THAT(error_with(TaskKind::score, "reference", 1e300),
              HasSubstr(".reference: must be a whole number"));
}

TEST(PlanFile, ATaskNeedsOnlyThoseBeforeIt) {
  EXPECT_THAT(error_with(TaskKind::snapshot, "deps", {"score:one/a/other/truth"}),
              HasSubstr(".deps[0]: is no task that stands before this one"));
  EXPECT_THAT(error_with(TaskKind::reference, "id", "snapshot:one/a/direct"), HasSubstr("stands twice"));
}

TEST(PlanFile, ABakeNeedsAnObjectAndAnOutput) {
  const auto bake = [](const nlohmann::json& changes) {
    auto json = nlohmann::ordered_json::parse(plan_to_json(test::plan_of(test::concrete_job())));
    auto& task = json["tasks"][0];
    task["kind"] = "bake";
    task["object"] = 0;
    task.update(changes);
    return error_of(json.dump());
  };
  EXPECT_EQ(bake({{"view", -1}}), "no error");
  EXPECT_THAT(bake({{"object", -1}}), HasSubstr(".object: must be between 0"));
  EXPECT_THAT(bake({{"outputs", nlohmann::json::array()}}), HasSubstr("a bake needs an output"));
}

TEST(PlanFile, TheJobOfAPlanHasNothingLeftToDecide) {
  const auto changed = [](auto change) {
    auto json = nlohmann::ordered_json::parse(plan_to_json(test::plan_of(test::concrete_job())));
    change(json);
    return error_of(json.dump());
  };
  EXPECT_THAT(changed([](auto& plan) {
                plan["job"]["scenes"][0].erase("views");
                plan["job"]["scenes"][0]["random"] = {{"count", 1}};
              }),
              HasSubstr("the views of scene 'one' are not written out"));
  EXPECT_THAT(changed([](auto& plan) {
                plan["job"]["variants"][1]["sweep"] = {{"k", {1, 2}}};
              }),
              HasSubstr("the variant 'other' has a sweep"));
  EXPECT_THAT(changed([](auto& plan) { plan["scene_hashes"] = {"one"}; }),
              HasSubstr("scene_hashes: there must be one for each scene"));
}

TEST(PlanFile, LongNamesThatASweepMadeAreReadBack) {
  Job job = test::concrete_job();
  job.variants[1].name = std::string(300, 'x');
  const std::string text = plan_to_json(test::plan_of(job));
  EXPECT_EQ(error_of(text), "no error");
}

}  // namespace
}  // namespace lightbench
