#include "scene/text_scan.h"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lightbench {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  LineScanner scanner(text);
  std::vector<std::string> lines;
  while (const auto line = scanner.next()) lines.emplace_back(*line);
  return lines;
}

TEST(LineScanner, EndsLinesAtLfCrlfAndCr) {
  EXPECT_EQ(lines_of("a\nb\r\nc\rd"), (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_EQ(lines_of("\n\n"), (std::vector<std::string>{"", ""}));
  EXPECT_TRUE(lines_of("").empty());
}

TEST(LineScanner, KnowsWhetherTheLastLineIsWhole) {
  LineScanner scanner("a\nb");
  scanner.next();
  EXPECT_TRUE(scanner.ended_by_newline());
  scanner.next();
  EXPECT_FALSE(scanner.ended_by_newline());
  EXPECT_EQ(scanner.line(), 2u);
}

TEST(TakeWord, SplitsAtBlanksAndTabs) {
  std::string_view rest = "  f\t1/2  3 ";
  EXPECT_EQ(take_word(rest), "f");
  EXPECT_EQ(take_word(rest), "1/2");
  EXPECT_EQ(take_word(rest), "3");
  EXPECT_EQ(take_word(rest), "");
}

TEST(WithoutComment, EndsWhereAWordBeginsWithAHash) {
  EXPECT_EQ(without_comment("1 2 # three"), "1 2 ");
  EXPECT_EQ(without_comment("#1"), "");
  EXPECT_EQ(without_comment("1\t#2"), "1\t");
  EXPECT_EQ(without_comment("-1.#IND 1.#INF"), "-1.#IND 1.#INF");
}

TEST(ClassifyNumber, AcceptsWhatFilesWrite) {
  for (const char* word : {"0", "-1", "+2.5", ".5", "-.5", "5.", "1e5", "1.E-5", "3.0e+02", "1e-400"})
    EXPECT_EQ(classify_number(word), NumberKind::finite) << word;
}

TEST(ClassifyNumber, TellsWhatIsNotFinite) {
  for (const char* word : {"nan", "-NaN", "inf", "-Infinity", "1.#IND", "-1.#INF", "-1.#IND00", "1.#QNAN0",
                           "1.#SNAN", "1.#J", "1e19", "1e99999", "nan(ind)"})
    EXPECT_EQ(classify_number(word), NumberKind::not_finite) << word;
}

TEST(ClassifyNumber, RejectsWhatIsNoNumber) {
  for (const char* word : {"", "-", ".", "1,5", "1.5f", "0x10", "1e", "1e+", "abc", "--1", "1.2.3",
                           "banana.png", "finance", "info", "nano", "inferno.jpg", "2nan", "x1.#IND"})
    EXPECT_EQ(classify_number(word), NumberKind::malformed) << word;
}

TEST(NumberOf, IsNothingWhereANumberIsTooSmall) {
  EXPECT_EQ(number_of("0." + std::string(400, '0') + "1"), 0);
  EXPECT_EQ(number_of("1e-400"), 0);
}

RC_GTEST_PROP(ClassifyNumber, AcceptsWhateverIsPrinted, (double x)) {
  RC_PRE(std::isfinite(x) && std::abs(x) < 1e18);
  const std::string text = fmt::format("{}", x);
  RC_ASSERT(classify_number(text) == NumberKind::finite);
  RC_ASSERT(number_of(text) == x);
}

}  // namespace
}  // namespace lightbench
