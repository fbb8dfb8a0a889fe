#include "reports/sequences.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reports/report_formats.h"
#include "tests/reports/sample_run.h"

namespace lightbench {
namespace {

using testing::HasSubstr;
using testing::Not;

/// One variant and one reference over three frames: errors 4, 5 and 6, flicker 1 and 3.
RunReport three_frames() {
  RunReport run;
  run.width = 32;
  run.height = 24;
  run.metric_names = {"mean_error", "flicker"};
  run.primary_reference = "truth";
  run.variants.resize(1);
  run.variants[0].name = "isr";
  run.references.resize(1);
  run.references[0].name = "truth";
  run.sequences = {{"box", "walk", {{"walk.000", 1}, {"walk.001", 1.5}, {"walk.002", 2}}}};
  for (int i = 0; i < 3; ++i) {
    const std::string view = "walk.00" + std::to_string(i);
    ReportImage image;
    image.scene = "box", image.view = view, image.source = "isr";
    image.png = view + ".png";
    run.images.push_back(image);
    ReportScore score;
    score.scene = "box", score.view = view, score.variant = "isr", score.reference = "truth";
    score.metrics["mean_error"] = MetricValue::of(4 + i);
    score.metrics["flicker"] =
        i == 0 ? MetricValue::undefined("no frame before") : MetricValue::of(2 * i - 1);
    run.scores.push_back(score);
  }
  return run;
}

std::string written(const std::string& format, const RunReport& run) {
  for (const ReportFormat& row : report_formats())
    if (row.name == format) return row.write(run).front().text;
  return "";
}

TEST(SequenceFacts, AreMeansAndTheWorstFrame) {
  const RunReport run = three_frames();
  const auto all = sequence_facts(run);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].variant, "isr");
  EXPECT_DOUBLE_EQ(*all[0].mean_error.value, 5);
  EXPECT_DOUBLE_EQ(*all[0].flicker.value, 2) << "of the two frames that have one";
  EXPECT_DOUBLE_EQ(*all[0].worst_flicker.value, 3);
  EXPECT_EQ(all[0].worst_view, "walk.002");
  ASSERT_EQ(all[0].by_frame.size(), 3u);
  EXPECT_FALSE(all[0].by_frame[0].value);
}

TEST(SequenceFacts, WithoutAnyFlickerHaveNoWorstFrame) {
  RunReport run = three_frames();
  for (ReportScore& score : run.scores) score.metrics.erase("flicker");
  const auto all = sequence_facts(run);
  EXPECT_FALSE(all[0].flicker.value);
  EXPECT_FALSE(all[0].worst_flicker.value);
  EXPECT_EQ(all[0].worst_view, "");
  EXPECT_DOUBLE_EQ(*all[0].mean_error.value, 5);
}

TEST(SequenceFacts, TheRateIsThatOfTheTimes) {
  EXPECT_DOUBLE_EQ(frame_rate(three_frames().sequences[0]), 2);
  EXPECT_EQ(frame_rate({"box", "walk", {{"a", 1}}}), 0);
}

TEST(SequenceReports, MarkdownHasTheirTable) {
  EXPECT_THAT(written("markdown", three_frames()),
              HasSubstr("| box/walk | isr | truth | 3 | 5.000 | 2.000 | 3.000 | walk.002 |"));
}

TEST(SequenceReports, HtmlHasATableAndAFilm) {
  const std::string page = written("html", three_frames());
  EXPECT_THAT(page, HasSubstr("id=\"sequence-table\""));
  EXPECT_THAT(page, HasSubstr("max=\"2\""));
  EXPECT_THAT(page, HasSubstr("src=\"walk.000.png\" data-source=\"isr\""));
  EXPECT_THAT(page, HasSubstr("\"sequences\":[{\"rate\":2.0,\"frames\":[0,1,2]}]"));
}

TEST(SequenceReports, NamesCannotBreakOutOfThePage) {
  RunReport run = three_frames();
  run.sequences[0].scene = run.images[0].scene = run.scores[0].scene = test::kHostileScene;
  run.sequences[0].name = test::kHostileView;
  EXPECT_THAT(written("html", run), Not(HasSubstr(test::kHostileScene)));
}

TEST(SequenceReports, JsonReadsBackToTheSame) {
  const std::string text = run_report_to_json(three_frames());
  const RunReport again = run_report_from_json(text, "run.json");
  ASSERT_EQ(again.sequences.size(), 1u);
  EXPECT_EQ(again.sequences[0].frames[1].time, 1.5);
  EXPECT_EQ(run_report_to_json(again), text);
}

TEST(SequenceReports, ARunWithoutThemShowsNothingOfThem) {
  const RunReport run = test::sample_run();
  EXPECT_THAT(written("markdown", run), Not(HasSubstr("Sequences")));
  EXPECT_THAT(written("html", run), Not(HasSubstr("id=\"sequences\"")));
  EXPECT_THAT(written("json", run), Not(HasSubstr("sequences")));
}

TEST(Sequences, OneWithoutFramesHasNoFilm) {
  RunReport run = three_frames();
  run.sequences[0].frames.clear();
  EXPECT_THAT(written("html", run), Not(HasSubstr("class=\"film\"")));
}

}  // namespace
}  // namespace lightbench
