#include "reports/line_chart.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using ::testing::HasSubstr;

TEST(LineChart, PutsPointsWhereTheAxesSay) {
  const std::string svg = line_chart({"t", "x", "y"}, {{"one", {{0, 0}, {50, 5}, {100, 10}}}});
  // From (60, 256) to (450, 30).
  EXPECT_THAT(svg, HasSubstr("points=\"60.0,256.0 255.0,143.0 450.0,30.0 \""));
}

TEST(LineChart, NamesLinesApartAndEscaped) {
  const std::string svg = line_chart({"a & b", "x", "y"}, {{"<one>", {{1, 1}}}, {"two", {{1, 1}}}});
  EXPECT_THAT(svg, HasSubstr("&lt;one&gt;"));
  EXPECT_THAT(svg, HasSubstr("a &amp; b"));
  EXPECT_THAT(svg, HasSubstr("y=\"34.0\" style=\"fill:#d55e00\">two"));
  EXPECT_THAT(svg, HasSubstr("y=\"19.0\" style=\"fill:#0072b2\">&lt;one"));
}

TEST(LineChart, OfNothingIsNothing) {
  EXPECT_EQ(line_chart({}, {}), "");
  EXPECT_EQ(line_chart({}, {{"one", {}}}), "");
  EXPECT_EQ(bar_chart({}, {0, 0}), "");
}

TEST(BarChart, HasABarForEachValueThatIsNotZero) {
  const std::string svg = bar_chart({"t", "x", "y"}, {1, 0, 2, 4});
  std::size_t bars = 0;
  for (std::size_t at = svg.find("<rect x"); at != std::string::npos; at = svg.find("<rect x", at + 1))
    ++bars;
  EXPECT_EQ(bars, 3U);
  EXPECT_THAT(svg, HasSubstr("height=\"226.00\""));
}

}  // namespace
}  // namespace lightbench
