#include "base/utf8.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace lightbench {
namespace {

TEST(CleanUtf8, KeepsWellFormedText) {
  EXPECT_EQ(clean_utf8("aé漢😀\t\n"), "aé漢😀\t\n");
}

TEST(CleanUtf8, ReplacesBrokenSequences) {
  EXPECT_EQ(clean_utf8("a\xffz"), "a\uFFFDz");
  EXPECT_EQ(clean_utf8("\xc3"), "\uFFFD");
  EXPECT_EQ(clean_utf8("\xc0\xaf"), "\uFFFD\uFFFD");            // overlong '/'
  EXPECT_EQ(clean_utf8("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");  // a surrogate
}

TEST(CleanUtf8, ReplacesControlCharacters) {
  EXPECT_EQ(clean_utf8(std::string("a\0b\x1b[31m", 8)), "a\uFFFDb\uFFFD[31m");
  EXPECT_EQ(clean_utf8("\xc2\x9b"), "\uFFFD");
  EXPECT_EQ(clean_utf8("\xef\xbf\xbe"), "\uFFFD");
}

TEST(CleanUtf8, ReplacesMarksThatTurnTheOrder) {
  EXPECT_EQ(clean_utf8("gnp.\u202Ex\u2066y\u200F"), "gnp.\uFFFDx\uFFFDy\uFFFD");
  EXPECT_EQ(clean_utf8("\u200D\u2027\u202F\u2065\u206A"), "\u200D\u2027\u202F\u2065\u206A");
}

TEST(CleanUtf8, ReplacesSeparatorsOfLines) {
  EXPECT_EQ(clean_utf8("a\u2028b\u2029c"), "a\uFFFDb\uFFFDc");
}

TEST(CleanUtf8, IsStable) {
  rc::check([](const std::string& bytes) { RC_ASSERT(clean_utf8(clean_utf8(bytes)) == clean_utf8(bytes)); });
}

TEST(PlainLine, IsOneLineWithoutControlCharacters) {
  EXPECT_EQ(plain_line("a\tb\r\nc\rd\x1b[2J\xff"), "a b c d\uFFFD[2J\uFFFD");
}

TEST(Shortened, CutsBetweenCodePoints) {
  EXPECT_EQ(shortened("éééé", 4), "éééé");
  EXPECT_EQ(shortened("ééééé", 4), "ééé…");
}

TEST(DisplayWidth, CountsCodePoints) {
  EXPECT_EQ(display_width("aé…"), 3u);
}

}  // namespace
}  // namespace lightbench
