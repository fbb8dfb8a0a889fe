#include "reports/ceiling.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using testing::HasSubstr;

ReportScore score(const std::string& view, const std::string& variant, double gain) {
  ReportScore result;
  result.scene = "room";
  result.view = view;
  result.variant = variant;
  result.reference = "povray";
  result.metrics["gain"] = MetricValue::of(gain);
  return result;
}

RunReport run_with_path(int bounces) {
  RunReport run;
  run.references = {{"povray", "povray", {}, 2, false, ""}};
  run.variants = {{"isr", "isr", {}, 2, false, ""}, {"path", "path_tracer", {}, bounces, true, ""}};
  run.scores = {score("a", "isr", 40), score("a", "path", 90), score("b", "isr", 20), score("b", "path", 98)};
  return run;
}

TEST(Ceiling, IsTheGainOfThePathTracedVariantOnTheSameView) {
  const RunReport run = run_with_path(2);
  EXPECT_EQ(ceiling_of(run, run.scores[0]), MetricValue::of(90));
  EXPECT_EQ(ceiling_of(run, run.scores[2]), MetricValue::of(98));
  EXPECT_EQ(mean_ceiling(run, "povray"), MetricValue::of(94));
}

TEST(Ceiling, NeedsTheBouncesOfTheReference) {
  const RunReport run = run_with_path(3);
  EXPECT_EQ(ceiling_variant(run, "povray"), nullptr);
  EXPECT_THAT(ceiling_of(run, run.scores[0]).undefined_because, HasSubstr("bounces"));
}

TEST(Ceiling, IsNotThatOfAVariantWithLimits) {
  RunReport run = run_with_path(2);
  run.variants[1].limited = true;
  EXPECT_EQ(ceiling_variant(run, "povray"), nullptr);
}

TEST(Ceiling, IsNotThatOfTheReferenceMadeTwice) {
  RunReport run = run_with_path(2);
  run.references[0].kind = "path_tracer";
  run.references[0].params = {{"samples", "64"}, {"seed", "1"}};
  run.variants[1].params = {{"samples", "16"}, {"seed", "1"}};
  EXPECT_EQ(ceiling_variant(run, "povray"), nullptr);
  EXPECT_FALSE(mean_ceiling(run, "povray").value);
  run.variants[1].params["seed"] = "2";
  EXPECT_NE(ceiling_variant(run, "povray"), nullptr);
}

TEST(Ceiling, StandsBesideAGainButNotBesideItself) {
  EXPECT_EQ(gain_text(MetricValue::of(40), MetricValue::of(90)), "40.00 / 90.00");
  EXPECT_EQ(gain_text(MetricValue::of(90), MetricValue::of(90)), "90.00");
  EXPECT_EQ(gain_text(MetricValue::of(40), MetricValue::undefined("none")), "40.00");
  EXPECT_EQ(gain_text(MetricValue::undefined("no error"), MetricValue::of(90)), "-");
}

}  // namespace
}  // namespace lightbench
