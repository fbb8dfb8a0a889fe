#include "pipeline/job_problems.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "job_fixture.h"

namespace lightbench {
namespace {

using test::error_of;
using test::kJobText;
using test::replaced;
using ::testing::HasSubstr;

std::size_t lines_of(const std::string& text) {
  return std::size_t(std::ranges::count(text, '\n'));
}

TEST(JobProblems, AllProblemsAreToldAtOnceWithTheirPlaces) {
  const std::string error = error_of(R"({
    "size": [0, 6], "smaples": 2,
    "scenes": [{"scene": "one.json", "views": [{"name": "a", "position": [0, 0, 1], "look_at": [0, 0, 0]}],
                "sequence": {"frames": 1, "rate": 0}},
               {"name": "two"}],
    "variants": [{"technique": "dierct", "name": ""}, {"technique": "ambient", "params": {"k": -1, "shadow": "x"}}],
    "references": [{"kind": "povray", "timeout": 0}],
    "metrics": ["gian", "rsme"],
    "difference": {"heat": 1}
  })");
  EXPECT_THAT(error, testing::StartsWith("/jobs/job.json: 14 problems:"));
  for (const char* place :
       {"$.size: ", "$: unknown key 'smaples'", "$.scenes[0].sequence.frames: ",
        "$.scenes[0].sequence.rate: ", "$.scenes[1]: the key 'scene' is missing",
        "$.scenes[1]: needs 'cameras'", "$.variants[0].technique: ", "$.variants[0].name: ",
        "$.variants[1].params.k: ", "$.variants[1].params: unknown key 'shadow'",
        "$.references[0].timeout: ", "$.metrics[0]: ", "$.metrics[1]: ", "$.difference.heat: "})
    EXPECT_THAT(error, HasSubstr(std::string("\n  /jobs/job.json: ") + place)) << place;
  EXPECT_EQ(lines_of(error), 14u);
}

TEST(JobProblems, AProblemOfAListBringsNoOthersOfItsNames) {
  const auto text =
      replaced(replaced(kJobText, R"("name": "other", "technique": "ambient")",
                        R"("name": "other", "technique": "ambeint")"),
               R"("metrics")",
               R"("baseline": "other", "gates": [{"metric": "gain", "variant": "other", "min": 0}],
                                "metrics")");
  EXPECT_THAT(error_of(text), testing::StartsWith("/jobs/job.json: $.variants[1].technique: "));
}

TEST(JobProblems, AllProblemsOfGatesAreTold) {
  const std::string error = error_of(replaced(
      kJobText, R"("metrics")",
      R"("gates": [{"metric": "gian", "variant": "othre", "scene": "thre"}, {"metric": "gain", "variant": "*",
          "over": "eahc", "min": 2, "max": 1}], "metrics")"));
  for (const char* place : {"$.gates[0].metric: ", "$.gates[0].variant: ", "$.gates[0].scene: ",
                            "$.gates[0]: a gate needs", "$.gates[1].over: ", "$.gates[1]: 'min' is above"})
    EXPECT_THAT(error, HasSubstr(place));
}

TEST(JobProblems, OneProblemIsToldAsItIs) {
  EXPECT_EQ(error_of(replaced(kJobText, "[8, 6]", "[8, 6, 1]")),
            "/jobs/job.json: $.size: must be [width, height]");
}

TEST(JobProblems, OfAMillionProblemsTheFirstAreTold) {
  std::string metrics = "\"x\"";
  for (int i = 0; i < 5000; ++i) metrics += ", \"x\"";
  const std::string error = error_of(replaced(kJobText, R"("mean_error", "gain")", metrics));
  EXPECT_THAT(error, HasSubstr("1000 problems or more:"));
  EXPECT_THAT(error, testing::EndsWith("and 950 more"));
}

}  // namespace
}  // namespace lightbench
