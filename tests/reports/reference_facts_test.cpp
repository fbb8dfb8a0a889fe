#include "reports/reference_facts.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

void add_image(RunReport& run, const std::string& view, const std::string& source, double luminance,
               std::optional<double> noise) {
  ReportImage image;
  image.scene = "room";
  image.view = view;
  image.source = source;
  image.is_reference = true;
  image.seconds = 2;
  image.cpu_seconds = 3;
  image.mean_luminance = luminance;
  image.noise = noise;
  run.images.push_back(image);
}

RunReport run_of_two_references() {
  RunReport run;
  run.references = {{"two", "povray", {}, 2, false, ""}, {"all", "path_tracer", {}, 16, false, ""}};
  add_image(run, "a", "two", 0.4, 0.5);
  add_image(run, "a", "all", 0.5, std::nullopt);
  add_image(run, "b", "two", 0.9, 0.25);
  add_image(run, "b", "all", 1.0, 0.125);
  return run;
}

TEST(ReferenceFacts, AreMeansOverTheViews) {
  const auto facts = reference_facts(run_of_two_references());
  ASSERT_EQ(facts.size(), 2u);
  EXPECT_EQ(facts[0].views, 2u);
  EXPECT_THAT(facts[0].noise, Optional(0.375));
  EXPECT_THAT(facts[0].worst_noise, Optional(0.5));
  EXPECT_THAT(facts[1].noise, Optional(0.125));
  EXPECT_EQ(facts[0].seconds, 2);
  EXPECT_EQ(facts[0].cpu_seconds, 6);
}

TEST(ReferenceFacts, CompareLightWithTheReferenceOfMostBounces) {
  const auto facts = reference_facts(run_of_two_references());
  EXPECT_NEAR(facts[0].light_share.value(), 0.85, 1e-12);
  EXPECT_FALSE(facts[1].light_share);
  EXPECT_THAT(light_share_lines(run_of_two_references()),
              ElementsAre("two (2 bounces) has 85.0 % of the light of all (16 bounces)"));
}

TEST(ReferenceFacts, LeaveOutViewsThatFailed) {
  RunReport run = run_of_two_references();
  run.images[1].outcome = Outcome::failed;
  EXPECT_NEAR(reference_facts(run)[0].light_share.value(), 0.9, 1e-12);
}

TEST(ReferenceFacts, OfEqualBouncesHaveNoShare) {
  RunReport run = run_of_two_references();
  run.references[1].bounces = 2;
  EXPECT_EQ(fullest_reference(run), nullptr);
  EXPECT_THAT(light_share_lines(run), IsEmpty());
}

TEST(ReferenceFacts, TellWhichVariantsHaveAnotherNumberOfBounces) {
  RunReport run = run_of_two_references();
  run.variants = {{"direct", "direct", {}, 0, false, ""},
                  {"isr", "isr", {}, 2, false, ""},
                  {"mine", "images", {}, 0, false, ""}};
  run.variants.back().external = true;
  EXPECT_THAT(bounces_lines(run),
              ElementsAre("two has 2 bounces of indirect light; other numbers: direct 0",
                          "all has 16 bounces of indirect light; other numbers: direct 0, isr 2"));
  run.variants.erase(run.variants.begin());
  run.references.pop_back();
  EXPECT_THAT(bounces_lines(run), IsEmpty());
}

}  // namespace
}  // namespace lightbench
