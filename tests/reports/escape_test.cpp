#include "reports/escape.h"

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

TEST(CleanUtf8, IsStable) {
  rc::check([](const std::string& bytes) { RC_ASSERT(clean_utf8(clean_utf8(bytes)) == clean_utf8(bytes)); });
}

TEST(EscapeMarkup, LeavesNoMarkup) {
  EXPECT_EQ(escape_markup("<a href='x' id=\"y\">&</a>"),
            "&lt;a href=&#39;x&#39; id=&quot;y&quot;&gt;&amp;&lt;/a&gt;");
}

TEST(RelativeUrl, EncodesEverythingThatMeansSomething) {
  EXPECT_EQ(relative_url("views/a b/é#?%.png"), "views/a%20b/%C3%A9%23%3F%25.png");
  EXPECT_EQ(relative_url("javascript:alert(1)"), "javascript%3Aalert%281%29");
}

TEST(RelativeUrl, NeverNamesAHost) {
  EXPECT_EQ(relative_url("//host/x.png"), ".//host/x.png");
}

TEST(EscapeJsonForScript, CannotCloseTheElement) {
  EXPECT_EQ(escape_json_for_script("\"</script><!--&\""), "\"\\u003c/script\\u003e\\u003c!--\\u0026\"");
}

TEST(EscapeMarkdown, IsOneLineWithoutMarkup) {
  EXPECT_EQ(escape_markdown("a|b\n*c* <d>"), "a\\|b \\*c\\* &lt;d&gt;");
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
