#include "pipeline/bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lightbench {
namespace {

TEST(Bench, MedianAndQuartilesOfAnOddNumber) {
  const BenchTime time = summarize("pass", {5, 1, 4, 2, 3});
  EXPECT_EQ(time.median, 3);
  EXPECT_EQ(time.lower, 2);
  EXPECT_EQ(time.upper, 4);
}

TEST(Bench, TheMedianOfAnEvenNumberLiesBetweenTheMiddleTwo) {
  EXPECT_EQ(summarize("pass", {4, 1, 2, 3}).median, 2.5);
}

TEST(Bench, OneValueIsItsOwnSpread) {
  const BenchTime time = summarize("pass", {7});
  EXPECT_EQ(time.lower, 7);
  EXPECT_EQ(time.upper, 7);
}

TEST(Bench, TheTableHasALineForEachPass) {
  const std::vector<BenchRow> rows = {
      {"s", "v", "direct", {{"all passes", 0.5, 0.4, 0.6}, {"shadow map", 0.1, 0.1, 0.1}}}};
  const std::string table = bench_table(rows);
  EXPECT_THAT(table, ::testing::HasSubstr("s/v/direct"));
  EXPECT_THAT(table, ::testing::HasSubstr("500.00"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
}

TEST(Bench, MeansAreOverViewsAndInTimesOfTheFirst) {
  const std::vector<BenchRow> rows = {{"s", "v", "direct", {{"all passes", 0.5, 0, 0}, {"direct", 9, 9, 9}}},
                                      {"s", "v", "isr", {{"all passes", 1, 0, 0}}},
                                      {"s", "w", "direct", {{"all passes", 1.5, 0, 0}}},
                                      {"s", "w", "isr", {{"all passes", 2, 0, 0}}}};
  const std::string means = bench_means(rows);
  EXPECT_THAT(means, ::testing::ContainsRegex("direct +2 +1000.00 +1.00\n"));
  EXPECT_THAT(means, ::testing::ContainsRegex("isr +2 +1500.00 +1.50\n"));
}

TEST(Bench, TheJsonKeepsSeconds) {
  Job job;
  job.name = "j";
  const auto json =
      nlohmann::json::parse(bench_json(job, {{"s", "v", "direct", {{"all passes", 0.5, 0.4, 0.6}}}}, 9, "r"));
  EXPECT_EQ(json["rounds"], 9);
  EXPECT_EQ(json["rows"][0]["passes"][0]["median_seconds"], 0.5);
}

}  // namespace
}  // namespace lightbench
