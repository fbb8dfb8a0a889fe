#include "reports/oracle_table.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

void add_view(RunReport& run, const std::string& view, double variant, double oracle, double ceiling) {
  for (const auto& [name, gain] :
       std::map<std::string, double>{{"best", variant}, {"best, oracle", oracle}, {"paths", ceiling}}) {
    ReportScore score;
    score.scene = "room";
    score.view = view;
    score.variant = name;
    score.reference = "povray";
    score.metrics["gain"] = MetricValue::of(gain);
    run.scores.push_back(score);
  }
}

RunReport two_views() {
  RunReport run;
  run.primary_reference = "povray";
  run.references = {{"povray", "povray", {}, 2, false, ""}};
  run.variants = {{"best", "isr", {}, 2, false, ""},
                  {"best, oracle", "isr_oracle", {}, 2, true, "", true},
                  {"paths", "path_tracer", {}, 2, true, ""}};
  add_view(run, "a", 60, 70, 96);
  add_view(run, "b|c", 80, 90, 98);
  return run;
}

const std::vector<OraclePair> kPairs{{"best", "best, oracle"}};

TEST(OracleTable, SplitsWhatIsLostBySearchingFromWhatIsUnseen) {
  const OracleTable table = oracle_table(two_views(), kPairs);
  ASSERT_THAT(table.views, SizeIs(2));
  EXPECT_EQ(table.views[0].view, "room/a");
  EXPECT_DOUBLE_EQ(table.views[0].lost_by_searching(), 10);
  EXPECT_DOUBLE_EQ(table.views[0].lost_unseen(), 26);
  EXPECT_EQ(table.left_out, 0u);
}

TEST(OracleTable, MeansAreOverTheViewsOfAPair) {
  const OracleTable table = oracle_table(two_views(), kPairs);
  ASSERT_THAT(table.means, SizeIs(1));
  EXPECT_EQ(table.means[0].view, "mean of 2 views");
  EXPECT_DOUBLE_EQ(table.means[0].gain, 70);
  EXPECT_DOUBLE_EQ(table.means[0].oracle, 80);
  EXPECT_DOUBLE_EQ(table.means[0].ceiling, 97);
}

TEST(OracleTable, AViewWithoutOneOfTheGainsIsLeftOutOfTheMean) {
  for (const std::size_t missing : {0u, 1u, 2u}) {
    RunReport run = two_views();
    run.scores[missing].outcome = Outcome::failed;
    const OracleTable table = oracle_table(run, kPairs);
    ASSERT_THAT(table.views, SizeIs(1)) << missing;
    EXPECT_EQ(table.views[0].view, "room/b|c");
    EXPECT_DOUBLE_EQ(table.means[0].gain, 80);
    EXPECT_EQ(table.left_out, 1u);
    EXPECT_THAT(oracle_text(table), HasSubstr("Left out"));
  }
}

TEST(OracleTable, OtherReferencesDoNotCount) {
  RunReport run = two_views();
  run.scores[0].reference = "other";
  EXPECT_THAT(oracle_table(run, kPairs).views, SizeIs(1));
}

TEST(OracleTable, MarkdownEscapesNames) {
  const std::string text = oracle_markdown(oracle_table(two_views(), kPairs));
  EXPECT_THAT(text, HasSubstr("| room/a | best | 60.0 | 70.0 | 96.0 | 10.0 | 26.0 |\n"));
  EXPECT_THAT(text, HasSubstr("b\\|c"));
  EXPECT_THAT(text, HasSubstr("| mean of 2 views | best | 70.0 | 80.0 | 97.0 | 10.0 | 17.0 |\n"));
}

TEST(OracleTable, TextHasARowForEachViewAndMean) {
  const std::string text = oracle_text(oracle_table(two_views(), kPairs));
  EXPECT_EQ(std::ranges::count(text, '\n'), 4);
}

}  // namespace
}  // namespace lightbench
