#include "base/text.h"

#include <gtest/gtest.h>

namespace lightbench {
namespace {

TEST(Text, NearestNameFindsMisspellingsOnly) {
  EXPECT_EQ(nearest_name("dircet", {"direct", "isr"}), "direct");
  EXPECT_EQ(nearest_name("isr48", {"direct", "isr"}), "isr");
  EXPECT_EQ(nearest_name("caustics", {"direct", "isr"}), std::nullopt);
  EXPECT_EQ(did_you_mean("x", {}), "");
}

TEST(Text, SplitAndJoinAreInverse) {
  EXPECT_EQ(split("a,,b", ','), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(join(split("a,,b", ','), ","), "a,,b");
}

TEST(Text, OneLineDropsBlanksAndBreaks) {
  EXPECT_EQ(one_line("\n a\r\n\n  b \n"), "a; b");
}

TEST(Text, GlobsMatchTheWholeName) {
  EXPECT_TRUE(matches_glob("office/front", "office/*"));
  EXPECT_TRUE(matches_glob("office/front", "*front"));
  EXPECT_FALSE(matches_glob("office/front", "office"));
}

}  // namespace
}  // namespace lightbench
