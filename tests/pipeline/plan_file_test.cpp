#include "pipeline/plan_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(PlanFile, AnotherVersionIsRefused) {
  const std::string text = plan_to_json(test::plan_of(test::concrete_job()));
  EXPECT_THAT(
      error_of(test::replaced(text, fmt::format("\"format\": {}", kPlanFormatVersion), "\"format\": 999")),
      HasSubstr("another version"));
}

TEST(PlanFile, WhatIsNoPlanIsRefused) {
  EXPECT_THAT(error_of("{}"), HasSubstr("is not a plan"));
  EXPECT_THAT(error_of("{\"format\": 2, "), HasSubstr("is not a plan"));
}

}  // namespace
}  // namespace lightbench
