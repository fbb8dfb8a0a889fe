#include "pipeline/job_schema.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "base/files.h"
#include "job_fixture.h"

namespace lightbench {
namespace {

const std::filesystem::path kJobs = std::filesystem::path(LIGHTBENCH_SOURCE_DIR) / "jobs";

/// Empty when the text keeps to the schema, else the first thing that is wrong.
std::string why_invalid(const std::string& text) {
  const nlohmann::json schema_json = nlohmann::json::parse(job_schema_text());
  valijson::Schema schema;
  valijson::SchemaParser parser;
  valijson::adapters::NlohmannJsonAdapter schema_adapter(schema_json);
  parser.populateSchema(schema_adapter, schema);
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, true, true);
  valijson::adapters::NlohmannJsonAdapter adapter(json);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema, adapter, &results)) return "";
  valijson::ValidationResults::Error error;
  results.popError(error);
  return error.description.empty() ? "invalid" : error.description;
}

TEST(JobSchema, TheCommittedFileIsWhatTheTablesGive) {
  EXPECT_EQ(read_file(kJobs / "job.schema.json"), job_schema_text())
      << "write it anew: lightbench schema > jobs/job.schema.json";
}

TEST(JobSchema, EveryJobOfTheProjectIsValid) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kJobs)) {
    const auto& file = entry.path();
    if (file.extension() != ".json" || file.string().ends_with(".schema.json")) continue;
    EXPECT_EQ(why_invalid(read_file(file)), "") << file;
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST(JobSchema, EveryJobOfTheProjectIsRead) {
  for (const char* name : {"cornell.json", "sample.json", "rooms.json"})
    EXPECT_NO_THROW(read_job(kJobs / name)) << name;
}

TEST(JobSchema, TheSampleUsesEveryKey) {
  const auto schema = nlohmann::json::parse(job_schema_text());
  const auto sample = nlohmann::json::parse(read_file(kJobs / "sample.json"), nullptr, true, true);
  for (const auto& [key, unused] : schema.at("properties").items()) EXPECT_TRUE(sample.contains(key)) << key;
}

TEST(JobSchema, WhatTheReaderTakesIsValid) {
  EXPECT_EQ(why_invalid(test::kJobText), "");
}

class JobSchemaError : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(JobSchemaError, IsFound) {
  EXPECT_NE(why_invalid(test::replaced(test::kJobText, GetParam().first, GetParam().second)), "");
}

INSTANTIATE_TEST_SUITE_P(
    All, JobSchemaError,
    ::testing::Values(
        std::pair(R"("metrics")", R"("metrix")"), std::pair(R"("gain"])", R"("gian"])"),
        std::pair(R"("ambient")", R"("ambeint")"), std::pair("[8, 6]", "[0, 6]"),
        std::pair(R"("technique": "direct")", R"("technique": "direct", "params": {"k": 1})"),
        std::pair(R"("technique": "ambient")", R"("technique": "ambient", "params": {"k": -1})"),
        std::pair(R"("kind": "povray")", R"("kind": "povray", "preset": "none")"),
        std::pair(R"("name": "two",)", R"("name": "two", "random": {"count": 1},)"),
        std::pair(R"("metrics")", R"("gates": [{"metric": "gain", "variant": "x"}], "metrics")")));

}  // namespace
}  // namespace lightbench
