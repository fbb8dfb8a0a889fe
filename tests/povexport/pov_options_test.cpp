#include <gmock/gmock.h>

#include "povexport/pov_scene.h"

namespace lightbench {
namespace {

PovOptions preset(const std::string& name) {
  return pov_options(resolve_params(pov_params(), pov_presets(), name, {}, "test"));
}

TEST(PovOptions, DefaultsOfTheRowsAreThoseOfTheStruct) {
  const PovOptions rows = preset("");
  const PovOptions defaults;
  EXPECT_EQ(rows.radiosity, defaults.radiosity);
  EXPECT_EQ(rows.brightness, defaults.brightness);
  EXPECT_EQ(rows.recursion_limit, defaults.recursion_limit);
  EXPECT_EQ(rows.count, defaults.count);
  EXPECT_EQ(rows.error_bound, defaults.error_bound);
  EXPECT_EQ(rows.pretrace_start, defaults.pretrace_start);
  EXPECT_EQ(rows.pretrace_end, defaults.pretrace_end);
  EXPECT_EQ(rows.shadowless, defaults.shadowless);
}

TEST(PovOptions, PaperIsTheThesisListing) {
  const PovOptions paper = preset("paper");
  EXPECT_EQ(paper.brightness, 2.4);
  EXPECT_TRUE(paper.shadowless);
  EXPECT_EQ(paper.recursion_limit, 2);
  EXPECT_EQ(paper.count, 250);
}

TEST(PovOptions, BouncesAreTheRecursionLimitOrNone) {
  EXPECT_EQ(pov_bounces(preset("physical")), 2);
  EXPECT_EQ(pov_bounces(preset("direct")), 0);
}

TEST(SecondOpinion, IsFinerInEverythingThatIsSampled) {
  const PovOptions options;
  const PovOptions finer = second_opinion(options);
  EXPECT_EQ(finer.count, 2 * options.count);
  EXPECT_EQ(finer.error_bound, options.error_bound / 2);
  EXPECT_LT(finer.pretrace_end, options.pretrace_end);
  EXPECT_EQ(finer.recursion_limit, options.recursion_limit);
  EXPECT_EQ(finer.brightness, options.brightness);
}

TEST(SecondOpinion, StaysWithinWhatPovrayTakes) {
  PovOptions options;
  options.count = 1500;
  EXPECT_EQ(second_opinion(options).count, 1600);
}

TEST(SecondOpinion, IsNotAskedForWhereNothingIsSampled) {
  const ParamValues values =
      resolve_params(pov_params(), pov_presets(), "direct", {{"estimate_noise", true}}, "");
  EXPECT_FALSE(pov_options(values).estimate_noise);
}

}  // namespace
}  // namespace lightbench
