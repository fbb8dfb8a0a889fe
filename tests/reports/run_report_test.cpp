#include "reports/run_report.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "base/error.h"
#include "base/files.h"
#include "tests/reports/sample_run.h"

namespace lightbench {
namespace {

using test::sample_run;
using testing::HasSubstr;

/// The schema's complaints about a run.json; empty where it is valid.
std::string schema_errors(const nlohmann::json& document) {
  using Adapter = valijson::adapters::NlohmannJsonAdapter;
  const auto schema_json = nlohmann::json::parse(read_file(LIGHTBENCH_SOURCE_DIR "/jobs/run.schema.json"));
  valijson::Schema schema;
  valijson::SchemaParser().populateSchema(Adapter(schema_json), schema);
  valijson::ValidationResults results;
  if (valijson::Validator().validate(schema, Adapter(document), &results)) return "";
  std::string text;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& step : error.context) text += step;
    text += ": " + error.description + "\n";
  }
  return text.empty() ? "invalid" : text;
}

nlohmann::json sample_json() {
  return nlohmann::json::parse(run_report_to_json(sample_run()));
}

std::string error_of(const nlohmann::json& document) {
  try {
    run_report_from_json(document.dump(), "run.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(RunReportJson, IsTheSameAfterReadingAndWritingAgain) {
  const std::string text = run_report_to_json(sample_run());
  EXPECT_EQ(run_report_to_json(run_report_from_json(text, "run.json")), text);
}

TEST(RunReportJson, KeepsEveryKindOfField) {
  const RunReport run = run_report_from_json(run_report_to_json(sample_run()), "run.json");
  EXPECT_EQ(run.scenes[0].triangles, 297123u);
  EXPECT_EQ(run.scenes[0].credits[0].license, "CC-BY 3.0");
  EXPECT_EQ(run.variants[1].params.at("samples"), "48");
  EXPECT_EQ(run.images[3].passes[1].seconds, 0.375);
  EXPECT_TRUE(run.images[2].cached);
  EXPECT_TRUE(run.images[0].is_reference);
  EXPECT_EQ(run.scores[3].outcome, Outcome::failed);
  EXPECT_EQ(run.scores[2].metrics.at("pearson"), MetricValue::undefined("the reference is constant"));
  EXPECT_EQ(run.scores[1].metrics.at("gain"), MetricValue::of(25));
  EXPECT_EQ(run.gates[0].state, GateState::not_met);
  EXPECT_EQ(run.gates[2].state, GateState::within_noise);
  EXPECT_EQ(run.bakes[0].variants, (std::vector<std::string>{"raw", "packed"}));
  EXPECT_EQ(run.bakes[0].ray_rates.at("shadow"), 2e7);
  EXPECT_EQ(run.bakes[1].noise, 0.1);
  EXPECT_TRUE(run.bakes[1].cached);
  EXPECT_EQ(run.compressions[0].numbers.at("bytes.mtnc"), MetricValue::of(2e5));
  EXPECT_EQ(run.compressions[1].outcome, Outcome::failed);
  EXPECT_EQ(run.images[0].noise, 0.25);
  EXPECT_FALSE(run.images[1].noise);
  EXPECT_EQ(run.images[1].ray_rates.at("primary"), 8e6);
  EXPECT_EQ(run.images[0].key, "0123456789abcdef");
  EXPECT_TRUE(run.variants[2].offline);
}

TEST(RunReportJson, MeetsItsSchema) {
  EXPECT_EQ(schema_errors(sample_json()), "");
}

TEST(RunReportJson, AnEmptyRunMeetsTheSchema) {
  EXPECT_EQ(schema_errors(nlohmann::json::parse(run_report_to_json({}))), "");
  RunReport moving;
  moving.sequences = {{"box", "walk", {{"walk.000", 0}, {"walk.001", 0.5}}}};
  EXPECT_EQ(schema_errors(nlohmann::json::parse(run_report_to_json(moving))), "");
}

TEST(RunReportJson, TheSchemaRefusesWhatTheReaderRefuses) {
  nlohmann::json unknown_key = sample_json();
  unknown_key["images"][0]["colour"] = "red";
  nlohmann::json null_metric = sample_json();
  null_metric["scores"][0]["metrics"]["gain"] = nullptr;
  nlohmann::json outcome = sample_json();
  outcome["scores"][0]["outcome"] = "fine";
  nlohmann::json nameless = sample_json();
  nameless["bakes"][0].erase("object");
  nlohmann::json null_number = sample_json();
  null_number["compressions"][0]["numbers"]["ratio"] = nullptr;
  for (const nlohmann::json& document : {unknown_key, null_metric, outcome, nameless, null_number}) {
    EXPECT_NE(schema_errors(document), "");
    EXPECT_NE(error_of(document), "no error");
  }
}

TEST(RunReportJson, NotANumberBecomesAReason) {
  RunReport run = sample_run();
  run.scores[0].metrics["gain"] = MetricValue::of(std::nan(""));
  run.seconds = INFINITY;
  const RunReport read = run_report_from_json(run_report_to_json(run), "run.json");
  EXPECT_EQ(read.scores[0].metrics.at("gain"), MetricValue::undefined("not a finite number"));
  EXPECT_EQ(read.seconds, 0);
}

TEST(RunReportJson, ErrorsSayThePlace) {
  nlohmann::json document = sample_json();
  document["scores"][1]["outcome"] = "okay";
  EXPECT_THAT(error_of(document), HasSubstr("run.json: $.scores[1].outcome"));
}

TEST(RunReportJson, AMissingFieldIsAnError) {
  nlohmann::json document = sample_json();
  document["images"][0].erase("source");
  EXPECT_THAT(error_of(document), AllOf(HasSubstr("$.images[0]"), HasSubstr("'source'")));
}

TEST(RunReportJson, AnotherFormatIsAnErrorOfItsOwn) {
  nlohmann::json document = sample_json();
  document["format"] = kRunFormatVersion + 1;
  document["something_new"] = 1;
  EXPECT_THAT(error_of(document), AllOf(HasSubstr("format 3"), HasSubstr("reads format 2")));
}

TEST(RunReportJson, TruncatedTextIsAnError) {
  const std::string text = run_report_to_json(sample_run());
  EXPECT_THROW(run_report_from_json(text.substr(0, text.size() / 2), "run.json"), Error);
}

TEST(MeanMetric, IsOverTheDefinedValues) {
  const MeanValue mean = mean_metric(sample_run(), "pearson", "direct", "povray");
  EXPECT_EQ(mean.mean, MetricValue::of(0.9));
  EXPECT_EQ(mean.count, 1u);
  EXPECT_EQ(mean.undefined, 1u);
}

TEST(MeanMetric, CountsFailedScoresAsUndefined) {
  const MeanValue mean = mean_metric(sample_run(), "gain", "isr-48", "povray");
  EXPECT_EQ(mean.mean, MetricValue::of(25));
  EXPECT_EQ(mean.undefined, 1u);
}

TEST(MeanMetric, OfOneScene) {
  EXPECT_EQ(mean_metric(sample_run(), "mean_error", "direct", "povray").mean, MetricValue::of(6));
  EXPECT_EQ(mean_metric(sample_run(), "mean_error", "direct", "povray", "office").mean, MetricValue::of(8));
}

TEST(MeanMetric, IsUndefinedWithoutAnyValue) {
  EXPECT_FALSE(mean_metric(sample_run(), "luv", "direct", "povray").mean.value.has_value());
  EXPECT_FALSE(mean_metric(sample_run(), "gain", "nobody", "povray").mean.value.has_value());
}

TEST(RunReportJson, ASequenceHasAFrame) {
  nlohmann::json run = sample_json();
  run["sequences"] = {{{"scene", "s"}, {"name", "walk"}, {"frames", nlohmann::json::array()}}};
  EXPECT_NE(schema_errors(run), "");
  EXPECT_EQ(error_of(run), "run.json: $.sequences[0]: a sequence has at least one frame");
}

}  // namespace
}  // namespace lightbench
