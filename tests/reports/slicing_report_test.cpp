#include "reports/slicing_report.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

SlicingTimes times(int planes, double all, double smart) {
  return {planes,
          planes / 2,
          {{"level map, all planes", all, all, all}, {"level map, smart", smart, smart, smart}},
          0};
}

SlicingReport report() {
  SlicingReport report;
  report.renderer = "osmesa";
  report.rounds = 3;
  report.receivers = {{"pool", "<ball>", "sun", {times(11, 30, 20), times(101, 300, 100)}, {0, 5, 2}},
                      {"pool", "a|b", "sun", {times(11, 10, 10), times(101, 100, 100)}, {1}}};
  return report;
}

std::string file(const SlicingReport& report, const std::string& name) {
  for (const auto& [written, text] : slicing_files(report))
    if (written == name) return text;
  return "";
}

TEST(SlicingReport, GivesEachReceiverAndTheMeans) {
  const std::string text = file(report(), "slicing.md");
  EXPECT_THAT(text, HasSubstr("| pool | &lt;ball&gt; | sun | 101 | 50 | 300 | 100 |"));
  EXPECT_THAT(text, HasSubstr("| 101 | 50 (50 to 50) | 200.0 (100.0 to 300.0) | 100.0 (100.0 to 100.0) |"));
  EXPECT_THAT(text, HasSubstr("2.00 (1.00 to 3.00)"));
  EXPECT_THAT(text, HasSubstr("a\\|b"));
}

TEST(SlicingReport, ThePageEscapesNames) {
  const std::string page = file(report(), "index.html");
  EXPECT_THAT(page, HasSubstr("&lt;ball&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<ball>")));
}

TEST(SlicingReport, DrawsChartsFromThreeNumbersOfPlanesOn) {
  SlicingReport two = report();
  EXPECT_THAT(file(two, "index.html"), Not(HasSubstr("<svg")));
  two.receivers[0].times.push_back(times(201, 600, 200));
  const std::string page = file(two, "index.html");
  EXPECT_THAT(page, HasSubstr("<polyline"));
  EXPECT_THAT(page, HasSubstr("<rect"));
}

TEST(SlicingReport, OfNothingIsNothing) {
  EXPECT_TRUE(slicing_files({}).empty());
}

}  // namespace
}  // namespace lightbench
