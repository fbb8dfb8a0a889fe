#include "base/json_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

JsonValue parse(const std::string& text) {
  return JsonValue::parse(text, "job.json");
}

TEST(JsonReader, ReadsValuesWithTheirTypes) {
  auto object = parse(R"({"a": 1.5, "b": [1, 2, 3], "c": "x", /* comment */ "d": true})").object();
  EXPECT_EQ(object.at("a").number(), 1.5);
  EXPECT_EQ(object.at("b").vec3(), glm::dvec3(1, 2, 3));
  EXPECT_EQ(object.at("c").text(), "x");
  EXPECT_TRUE(object.at("d").boolean());
  EXPECT_NO_THROW(object.finish());
}

TEST(JsonReader, ErrorsSayTheJsonPath) {
  auto views = parse(R"({"views": [{"fov": 60}, {"fov": "wide"}]})").object().at("views").items();
  EXPECT_THAT(error_of([&] { views[1].object().at("fov").number(); }),
              AllOf(HasSubstr("job.json: $.views[1].fov"), HasSubstr("must be a number, not a text")));
}

TEST(JsonReader, UnknownKeysNameTheNearestKnownOne) {
  auto object = parse(R"({"widht": 3})").object();
  object.find("width");
  EXPECT_THAT(error_of([&] { object.finish(); }), HasSubstr("unknown key 'widht' (did you mean 'width'?)"));
}

TEST(JsonReader, SyntaxErrorsSayTheLine) {
  EXPECT_THAT(error_of([] { parse("{\n\"a\": 1,\n\"b\" 2}"); }), HasSubstr("job.json:3"));
  EXPECT_THAT(error_of([] { parse("{\"a\": [1, 2"); }), HasSubstr("job.json:1"));
}

TEST(JsonReader, AKeyThatStandsTwiceIsAnError) {
  EXPECT_THAT(error_of([] { parse(R"({"a": {"x": 1, "x": 2}})"); }), HasSubstr("'x' stands twice"));
  EXPECT_NO_THROW(parse(R"({"a": {"x": 1}, "b": {"x": 2}})"));
}

TEST(JsonReader, RangesAndChoicesAreChecked) {
  EXPECT_THAT(error_of([] { parse("7").number(0, 5); }), HasSubstr("between 0 and 5, not 7"));
  EXPECT_THAT(error_of([] { parse("1.5").integer(); }), HasSubstr("whole number"));
  EXPECT_THAT(error_of([] { parse("\"1\"").integer(); }), HasSubstr("must be a whole number, not a text"));
  EXPECT_THAT(error_of([] { parse("1e400").number(); }), HasSubstr("job.json"));
  EXPECT_THAT(error_of([] { parse("\"emx\"").choice({"esm", "pcf"}); }), HasSubstr("did you mean 'esm'?"));
}

TEST(JsonReader, MissingKeysAreNamed) {
  EXPECT_THAT(error_of([] { parse("{}").object().at("scene"); }), HasSubstr("the key 'scene' is missing"));
}

TEST(JsonReader, LimitsStopTheReading) {
  const JsonLimits limits{.bytes = 1000, .values = 4, .keys = 2, .depth = 2};
  const auto error = [&](const char* text) {
    return error_of([&] { JsonValue::parse(text, "job.json", limits); });
  };
  EXPECT_EQ(error("[1, 2, 3]"), "no error");
  EXPECT_EQ(error("[1, 2, 3, 4]"), "job.json: there are more than 4 values");
  EXPECT_EQ(error("[[1]]"), "no error");
  EXPECT_EQ(error("[[[]]]"), "job.json: lists and objects stand in one another more than 2 deep");
  EXPECT_EQ(error(R"({"a": 1, "b": 2})"), "no error");
  EXPECT_EQ(error(R"({"a": 1, "b": 2, "c": 3})"), "job.json: an object has more than 2 keys");
}

TEST(JsonReader, DepthIsLimitedBeforeTheStackIs) {
  EXPECT_THAT(error_of([] { parse(std::string(8'000'000, '[')); }), HasSubstr("in one another"));
}

TEST(JsonReader, UnknownKeysAreListedInOrder) {
  auto object = parse(R"({"z": 1, "known": 2, "a": 3})").object();
  object.find("known");
  EXPECT_EQ(object.unknown(), (std::vector<std::string>{"z", "a"}));
}

TEST(JsonReader, ANumberThatIsTooLargeIsToldInPlainWords) {
  try {
    JsonValue::parse(R"({"max": 1e999})", "job.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "job.json: number overflow parsing '1e999'");
  }
}

}  // namespace
}  // namespace lightbench
