#include "base/json_bytes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include "base/json_reader.h"

namespace lightbench {
namespace {

using Json = nlohmann::ordered_json;

const std::string kLatin1 = "Fen\xEAtre.png";

TEST(JsonBytes, TextStaysAsItIs) {
  EXPECT_EQ(utf8_of_bytes("Fenêtre 漢 😀"), "Fenêtre 漢 😀");
  EXPECT_EQ(bytes_of_utf8("Fenêtre 漢 😀"), "Fenêtre 漢 😀");
}

TEST(JsonBytes, EachOtherByteIsOneCodePoint) {
  EXPECT_EQ(utf8_of_bytes(kLatin1), "Fen\U0010FFEAtre.png");
  EXPECT_EQ(utf8_of_bytes("\x80\xBF"), "\U0010FF80\U0010FFBF");
}

TEST(JsonBytes, TheCodePointsThemselvesSurvive) {
  EXPECT_EQ(bytes_of_utf8(utf8_of_bytes("\U0010FFEA")), "\U0010FFEA");
}

RC_GTEST_PROP(JsonBytes, AnyBytesSurvive, (const std::string& bytes)) {
  const Json json = {{"name", bytes}, {"list", {bytes, 1, nullptr}}};
  RC_ASSERT(bytes_of_utf8(utf8_of_bytes(bytes)) == bytes);
  RC_ASSERT(parse_json_text(json_text(json)) == json);
  RC_ASSERT(parse_json_text(json_text(json, 2)) == json);
}

TEST(JsonBytes, KeysAreText) {
  EXPECT_EQ(json_text(Json{{kLatin1, 1}}), "{\"Fen\uFFFDtre.png\":1}");
}

TEST(JsonBytes, TheStrictReaderGivesTheBytesBack) {
  const std::string text = json_text(Json{{"scene", kLatin1}});
  EXPECT_EQ(JsonValue::parse(text, "job.json").object().at("scene").text(), kLatin1);
}

}  // namespace
}  // namespace lightbench
