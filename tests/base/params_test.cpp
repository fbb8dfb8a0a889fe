#include "base/params.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

const std::vector<ParamSpec> kSpecs = {
    integer_param("samples", 48, 1, 4096, ""),
    number_param("radius", 0.5, 0, 10, ""),
    choice_param("shadows", {"none", "hard", "esm"}, "hard", ""),
    boolean_param("paper_normals", false, ""),
};
const std::vector<ParamPreset> kPresets = {{"soft", {{"shadows", std::string("esm")}, {"radius", 2LL}}, ""}};

std::string error_of(const std::string& preset, const std::map<std::string, ParamValue>& given) {
  try {
    resolve_params(kSpecs, kPresets, preset, given, "job.json: $.variants[0]");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Params, DefaultsThenPresetThenGivenValues) {
  const auto values = resolve_params(kSpecs, kPresets, "soft", {{"radius", 3.0}}, "here");
  EXPECT_EQ(values.integer("samples"), 48);
  EXPECT_EQ(values.text("shadows"), "esm");
  EXPECT_EQ(values.number("radius"), 3.0);
}

TEST(Params, WholeNumbersStandForNumbersAndBack) {
  const auto values = resolve_params(kSpecs, kPresets, "", {{"radius", 3LL}, {"samples", 8.0}}, "here");
  EXPECT_EQ(values.number("radius"), 3.0);
  EXPECT_EQ(values.integer("samples"), 8);
}

TEST(Params, MistakesNameTheNearestAndThePlace) {
  EXPECT_THAT(error_of("", {{"sampels", 3LL}}), HasSubstr("did you mean 'samples'?"));
  EXPECT_THAT(error_of("sift", {}), HasSubstr("did you mean 'soft'?"));
  EXPECT_THAT(error_of("", {{"shadows", std::string("ems")}}), HasSubstr("did you mean 'esm'?"));
  EXPECT_THAT(error_of("", {{"radius", 11.0}}), HasSubstr("$.variants[0]"));
  EXPECT_THAT(error_of("", {{"samples", 1.5}}), HasSubstr("whole number"));
  EXPECT_THAT(error_of("", {{"samples", std::string("1")}}), HasSubstr("a whole number, not the text '1'"));
  EXPECT_THAT(error_of("", {{"paper_normals", std::string("yes")}}), HasSubstr("true or false"));
}

TEST(Params, CommandLineTextIsReadByType) {
  EXPECT_EQ(parse_param(kSpecs[0], "24", "x"), ParamValue(24LL));
  EXPECT_EQ(parse_param(kSpecs[3], "true", "x"), ParamValue(true));
  EXPECT_THROW(parse_param(kSpecs[1], "0.5x", "x"), Error);
  EXPECT_THROW(parse_param(kSpecs[1], "nan", "x"), Error);
}

TEST(Params, TextIsTheShortestThatReadsBack) {
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(48LL), "48");
  EXPECT_EQ(to_text(true), "true");
}

}  // namespace
}  // namespace lightbench
