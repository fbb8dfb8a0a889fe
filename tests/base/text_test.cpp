#include "base/text.h"

#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lightbench {
namespace {

TEST(Text, NearestNameFindsMisspellingsOnly) {
  EXPECT_EQ(nearest_name("dircet", {"direct", "isr"}), "direct");
  EXPECT_EQ(nearest_name("isr48", {"direct", "isr"}), "isr");
  EXPECT_EQ(nearest_name("caustics", {"direct", "isr"}), std::nullopt);
  EXPECT_EQ(did_you_mean("x", {}), "");
}

/// By the whole table of distances.
std::optional<std::string> nearest_by_all_distances(const std::string& name,
                                                    const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    std::vector<std::size_t> row(candidate.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < name.size(); ++i) {
      std::size_t diagonal = row[0]++;
      for (std::size_t j = 0; j < candidate.size(); ++j) {
        const std::size_t replaced = diagonal + (name[i] != candidate[j]);
        diagonal = row[j + 1];
        row[j + 1] = std::min({row[j + 1] + 1, row[j] + 1, replaced});
      }
    }
    if (row.back() >= least || row.back() >= candidate.size()) continue;
    least = row.back();
    best = candidate;
  }
  return best;
}

RC_GTEST_PROP(Text, TheNearestNameIsThatOfTheWholeTable, ()) {
  const auto letters = rc::gen::container<std::string>(rc::gen::element('a', 'b', 'c'));
  const std::string name = *letters;
  const auto candidates = *rc::gen::container<std::vector<std::string>>(letters);
  RC_ASSERT(nearest_name(name, candidates) == nearest_by_all_distances(name, candidates));
}

TEST(Text, PatternsAreThoseThatMeanMore) {
  EXPECT_TRUE(is_pattern("a*") && is_pattern("[ab]") && is_pattern("?") && is_pattern("\\*"));
  EXPECT_FALSE(is_pattern("a.b-c"));
}

TEST(Text, SplitAndJoinAreInverse) {
  EXPECT_EQ(split("a,,b", ','), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(join(split("a,,b", ','), ","), "a,,b");
}

TEST(Text, OneLineDropsBlanksAndBreaks) {
  EXPECT_EQ(one_line("\n a\r\n\n  b \n"), "a; b");
}

TEST(Text, LastLinesAreShortAndNotBlank) {
  EXPECT_EQ(last_lines("a\n b \n\nc\n", 2), (std::vector<std::string>{"b", "c"}));
  EXPECT_EQ(last_lines("", 2), std::vector<std::string>());
  EXPECT_LE(last_lines(std::string(8'000'000, 'x'), 2).at(0).size(), 510u);
}

TEST(Text, GlobsMatchTheWholeName) {
  EXPECT_TRUE(matches_glob("office/front", "office/*"));
  EXPECT_TRUE(matches_glob("office/front", "*front"));
  EXPECT_FALSE(matches_glob("office/front", "office"));
}

}  // namespace
}  // namespace lightbench
