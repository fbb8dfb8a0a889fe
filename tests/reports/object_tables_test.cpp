#include "reports/object_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/sample_run.h"

namespace lightbench {
namespace {

using test::kHostileObject;
using test::sample_run;
using testing::ElementsAre;
using testing::StartsWith;

ReportObject compressed(const std::string& object, const std::map<std::string, double>& numbers) {
  ReportObject result;
  result.scene = "s";
  result.object = object;
  result.variants = {"v"};
  for (const auto& [name, value] : numbers) result.numbers[name] = MetricValue::of(value);
  return result;
}

/// Of two objects: one large and nearly lossless, one small with large errors.
RunReport two_objects() {
  RunReport run;
  run.compressions = {compressed("large", {{"width", 10},
                                           {"height", 20},
                                           {"texels", 150},
                                           {"directions", 400},
                                           {"raw_bytes", 9e6},
                                           {"bytes.a", 2e5},
                                           {"bytes.b", 1e5},
                                           {"changed_values", 1e5},
                                           {"mean_changed_error", 1},
                                           {"error_99", 2},
                                           {"max_error", 9},
                                           {"max_component_error", 12},
                                           {"colors", 100}}),
                      compressed("small", {{"width", 5},
                                           {"height", 5},
                                           {"texels", 25},
                                           {"directions", 400},
                                           {"raw_bytes", 3e6},
                                           {"bytes.a", 2e5},
                                           {"bytes.b", 1e5},
                                           {"changed_values", 3e5},
                                           {"mean_changed_error", 2},
                                           {"error_99", 6},
                                           {"max_error", 7},
                                           {"max_component_error", 20},
                                           {"colors", 50}})};
  return run;
}

std::string cell(const ObjectTable& table, const ObjectRow& row, const std::string& heading) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i].heading == heading) return row.cells.at(i);
  return "no column " + heading;
}

std::string whole(const RunReport& run, const std::string& heading) {
  const ObjectTable table = compression_tables(run).at(0);
  return cell(table, table.whole, heading);
}

TEST(CompressionTables, HaveARowForEachObject) {
  const ObjectTable table = compression_tables(two_objects()).at(0);
  EXPECT_EQ(table.variants, "v");
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].object, "large");
  EXPECT_EQ(cell(table, table.rows[0], "texture"), "10x20");
  EXPECT_EQ(cell(table, table.rows[0], "raw MB"), "9.00");
  EXPECT_EQ(cell(table, table.rows[0], "b MB"), "0.100");
  EXPECT_EQ(cell(table, table.rows[0], "ratio"), "30.0");
  EXPECT_EQ(cell(table, table.rows[1], "mean error"), "2.00");
  EXPECT_EQ(cell(table, table.rows[1], "colours"), "50");
}

TEST(CompressionTables, TheWholeSceneSumsBytes) {
  EXPECT_EQ(whole(two_objects(), "texels"), "175");
  EXPECT_EQ(whole(two_objects(), "directions"), "400");
  EXPECT_EQ(whole(two_objects(), "a MB"), "0.400");
  EXPECT_EQ(whole(two_objects(), "ratio"), "20.0") << "12 over 0.6, not the mean of 30 and 10";
}

TEST(CompressionTables, TheWholeScenesErrorIsWeightedByChangedValues) {
  EXPECT_EQ(whole(two_objects(), "mean error"), "1.75") << "(1 * 1 + 3 * 2) / 4";
  EXPECT_EQ(whole(two_objects(), "changed %"), "10.0") << "0.4 of 4 million values";
}

TEST(CompressionTables, TheWholeSceneShowsTheWorst) {
  EXPECT_EQ(whole(two_objects(), "99 %"), "6.00");
  EXPECT_EQ(whole(two_objects(), "max"), "9.00");
  EXPECT_EQ(whole(two_objects(), "max of a component"), "20");
}

TEST(CompressionTables, WhatCannotBeSummedUpIsLeftOut) {
  EXPECT_EQ(whole(two_objects(), "texture"), "-");
  EXPECT_EQ(whole(two_objects(), "colours"), "-") << "objects may share colours";
}

TEST(CompressionTables, WithoutChangedValuesTheErrorIsNone) {
  RunReport run = two_objects();
  for (ReportObject& object : run.compressions) object.numbers["changed_values"] = MetricValue::of(0);
  EXPECT_EQ(whole(run, "mean error"), "0.00");
}

TEST(CompressionTables, AFailedObjectSaysSoAndIsLeftOutOfTheSum) {
  RunReport run = two_objects();
  run.compressions[1].outcome = Outcome::failed;
  run.compressions[1].error = "disk full";
  run.compressions[1].numbers.clear();
  const ObjectTable table = compression_tables(run).at(0);
  EXPECT_EQ(table.rows[1].problem, "failed: disk full");
  EXPECT_EQ(table.whole.object, "whole scene (1 of 2 objects)");
  EXPECT_EQ(cell(table, table.whole, "ratio"), "30.0");
}

TEST(CompressionTables, WithoutAnyNumbersThereIsStillATable) {
  RunReport run;
  run.compressions = {compressed("only", {})};
  run.compressions[0].outcome = Outcome::skipped;
  const ObjectTable table = compression_tables(run).at(0);
  EXPECT_EQ(table.rows[0].problem, "skipped");
  EXPECT_EQ(cell(table, table.whole, "ratio"), "-");
}

TEST(CompressionTables, AMissingNumberIsNotTakenForNone) {
  RunReport run = two_objects();
  run.compressions[1].numbers.erase("bytes.b");
  EXPECT_EQ(whole(run, "b MB"), "-");
  run.compressions[1].numbers["bytes.a"] = MetricValue::undefined("lost");
  EXPECT_EQ(whole(run, "ratio"), "-");
}

TEST(CompressionTables, ScenesAndVariantsHaveTheirOwn) {
  RunReport run = two_objects();
  run.compressions[1].variants = {"v", "w"};
  run.compressions.push_back(run.compressions[0]);
  run.compressions.back().scene = "another";
  EXPECT_EQ(compression_tables(run).size(), 3u);
}

TEST(BakeTables, RatesAreOfProcessorTime) {
  const ObjectTable table = bake_tables(sample_run()).at(0);
  EXPECT_EQ(cell(table, table.rows[0], "CPU s"), "4.00");
  EXPECT_EQ(cell(table, table.rows[0], "texels/s"), "3000");
  EXPECT_EQ(cell(table, table.rows[0], "million radiance samples/s"), "1.20");
  EXPECT_EQ(cell(table, table.whole, "texels/s"), "3200") << "16000 texels in 5 s";
}

TEST(BakeTables, NoiseIsTheMeanOverTexels) {
  const ObjectTable table = bake_tables(sample_run()).at(0);
  EXPECT_EQ(cell(table, table.rows[1], "noise of 255"), "0.10");
  EXPECT_EQ(cell(table, table.whole, "noise of 255"), "0.40") << "(3 * 0.5 + 1 * 0.1) / 4";
}

TEST(BakeTables, ObjectsKeepTheirNames) {
  EXPECT_EQ(bake_tables(sample_run()).at(0).rows.at(1).object, kHostileObject);
}

TEST(BakeTables, ARunWithoutBakesHasNone) {
  EXPECT_TRUE(bake_tables({}).empty());
  EXPECT_TRUE(object_lines({}).empty());
}

TEST(ObjectLines, SumUpEachTable) {
  EXPECT_THAT(object_lines(two_objects()),
              ElementsAre("compressed s (v): 2 objects, 12.0 MB to 0.60 MB (20.0 : 1), mean error 1.75 where "
                          "changed, at most 9.00 of 255"));
  EXPECT_THAT(object_lines(sample_run()),
              ElementsAre(StartsWith("baked office (raw; packed): 2 objects, 16000 texels"),
                          StartsWith("compressed office (packed): 1 of 2 objects")));
}

}  // namespace
}  // namespace lightbench
