#include "reports/escape.h"

#include <gtest/gtest.h>

namespace lightbench {
namespace {

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

// As cmark-gfm with its extension `autolink` shows: these make no link, and what the cell shows is the text.
TEST(EscapeMarkdown, AddressesDoNotBecomeLinks) {
  EXPECT_EQ(escape_markdown("www.example.com"), "www\\.example.com");
  EXPECT_EQ(escape_markdown("(WWW.example.com"), "\\(WWW\\.example.com");
  EXPECT_EQ(escape_markdown("https://example.com"), "https\\://example.com");
  EXPECT_EQ(escape_markdown("a@b.com"), "a@<!-- -->b.com");
  EXPECT_EQ(escape_markdown("mailto:a@b.com"), "mailto\\:a@<!-- -->b.com");
  EXPECT_EQ(escape_markdown("ww.x wwe.x 0.5"), "ww.x wwe.x 0.5");
}

}  // namespace
}  // namespace lightbench
