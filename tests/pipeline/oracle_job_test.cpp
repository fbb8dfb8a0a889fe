#include "pipeline/oracle_job.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "job_fixture.h"
#include "pipeline/job_file.h"
#include "pipeline/tables.h"

namespace lightbench {
namespace {

using test::kJobText;
using test::replaced;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The fixture's job with these variants beside `direct`.
Job job_with(const std::string& variants) {
  return parse_job(replaced(kJobText, R"({"name": "other", "technique": "ambient"})", variants),
                   "/jobs/job.json");
}

OracleJob made(const std::string& variants) {
  return oracle_job(job_with(variants));
}

const JobVariant& variant_called(const Job& job, const std::string& name) {
  for (const JobVariant& variant : job.variants)
    if (variant.name == name) return variant;
  throw std::out_of_range(name);
}

const char* const kFast = R"({"name": "fast", "technique": "isr", "preset": "fast", "params": {"guard": 3}})";

const std::string kThree =
    std::string(kFast) +
    R"(, {"name": "ambient", "technique": "ambient"}, {"name": "best", "technique": "isr", "preset": "best"})";

TEST(OracleJob, PutsAnOracleBehindEachVariantOfIsrAndTheCeilingLast) {
  const OracleJob result = made(kThree);
  EXPECT_THAT(row_names(result.job.variants),
              ElementsAre("direct", "fast", "fast, oracle", "ambient", "best", "best, oracle", "ceiling"));
  EXPECT_THAT(result.pairs,
              ElementsAre(OraclePair{"fast", "fast, oracle"}, OraclePair{"best", "best, oracle"}));
  EXPECT_EQ(result.job.name, "job-oracle");
}

TEST(OracleJob, OfChosenVariantsKeepsTheBaselineAndTheCeiling) {
  const OracleJob result = oracle_job(
      job_with(kThree + R"(, {"name": "paths", "technique": "path_tracer", "params": {"bounces": 2}})"),
      {"best"});
  EXPECT_THAT(row_names(result.job.variants), ElementsAre("direct", "best", "best, oracle", "paths"));
}

TEST(OracleJob, WithoutVisibilityTheFrameAndOneBounceAreSeen) {
  const OracleJob result = made(
      R"({"name": "area", "technique": "isr",
          "params": {"guard": 3, "bounces": 2, "unknown": "ambient", "background": false}})");
  const ParamValues params = variant_params(variant_called(result.job, "area, oracle"));
  EXPECT_EQ(params.number("guard"), 1);
  EXPECT_EQ(params.integer("bounces"), 1);
  EXPECT_EQ(params.text("unknown"), "black");
  EXPECT_FALSE(params.boolean("background"));
}

TEST(OracleJob, AnOracleSeesWhatItsVariantSees) {
  const OracleJob result = made(kFast);
  const ParamValues params = variant_params(variant_called(result.job, "fast, oracle"));
  EXPECT_EQ(params.number("guard"), 3);
  EXPECT_EQ(params.integer("bounces"), 2);
  EXPECT_EQ(params.text("unknown"), "ambient");
  EXPECT_EQ(params.text("cameras"), "none");
  EXPECT_EQ(params.integer("samples"), 256) << "not the samples of the variant's kernel";
}

TEST(OracleJob, VariantsThatSeeTheSameShareAnOracle) {
  const OracleJob result =
      made(R"({"name": "best", "technique": "isr", "preset": "best", "sweep": {"steps": [24, 48]}})");
  EXPECT_THAT(row_names(result.job.variants),
              ElementsAre("direct", "best[steps=24]", "best[steps=24], oracle", "best[steps=48]", "ceiling"));
  EXPECT_THAT(result.pairs, ElementsAre(OraclePair{"best[steps=24]", "best[steps=24], oracle"},
                                        OraclePair{"best[steps=48]", "best[steps=24], oracle"}));
}

TEST(OracleJob, IndirectLightAloneHasNoOracle) {
  const OracleJob result =
      made(std::string(kFast) +
           R"(, {"name": "alone", "technique": "isr", "preset": "best", "params": {"direct": false}})");
  EXPECT_THAT(result.pairs, ElementsAre(OraclePair{"fast", "fast, oracle"}));
}

TEST(OracleJob, TheCeilingHasTheBouncesOfThePrimaryReference) {
  const ParamValues params = variant_params(variant_called(made(kFast).job, "ceiling"));
  EXPECT_EQ(params.integer("bounces"), 2) << "POV-Ray's preset physical";
}

TEST(OracleJob, ACeilingThatIsThereStays) {
  const OracleJob result = made(
      std::string(kFast) + R"(, {"name": "paths", "technique": "path_tracer", "params": {"bounces": 2}})");
  EXPECT_THAT(row_names(result.job.variants), ElementsAre("direct", "fast", "fast, oracle", "paths"));
}

TEST(OracleJob, NamesThatAreTakenGetANumber) {
  const OracleJob result = made(std::string(kFast) + R"(, {"name": "ceiling", "technique": "ambient"})");
  EXPECT_EQ(result.job.variants.back().name, "ceiling 2");
}

TEST(OracleJob, LeavesGatesOutAndMeasuresGains) {
  Job job = job_with(kFast);
  job.metrics = {"mean_error"};
  job.gates.emplace_back();
  const OracleJob result = oracle_job(job);
  EXPECT_TRUE(result.job.gates.empty());
  EXPECT_THAT(result.job.metrics, ElementsAre("mean_error", "gain"));
}

TEST(OracleJob, ReadsBackFromItsText) {
  const Job job = made(kFast).job;
  const Job again = parse_job(job_text(job), "/out/job.json");
  EXPECT_EQ(row_names(again.variants), row_names(job.variants));
  EXPECT_EQ(variant_params(variant_called(again, "fast, oracle")).all(),
            variant_params(variant_called(job, "fast, oracle")).all());
}

void expect_error(const Job& job, const std::string& text, const std::vector<std::string>& only = {}) {
  try {
    oracle_job(job, only);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(text));
    EXPECT_THAT(error.what(), HasSubstr("/jobs/job.json"));
  }
}

TEST(OracleJob, SaysWhatAJobLacks) {
  expect_error(job_with(R"({"name": "other", "technique": "ambient"})"), "technique 'isr'");
  expect_error(job_with(kFast), "no variant 'fats' (did you mean 'fast'?)", {"fats"});
  Job job = job_with(kFast);
  job.baseline.clear();
  expect_error(job, "baseline");
  job = job_with(kFast);
  job.primary_reference.clear();
  expect_error(job, "reference");
}

}  // namespace
}  // namespace lightbench
