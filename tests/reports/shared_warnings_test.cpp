#include "reports/shared_warnings.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

ReportScore score_of(const std::string& view, std::vector<std::string> warnings) {
  ReportScore score;
  score.scene = "room";
  score.view = view;
  score.variant = "isr";
  score.reference = "truth";
  score.warnings = std::move(warnings);
  return score;
}

TEST(SharedWarnings, AreToldOnceWithAllThatTheyAreAbout) {
  RunReport run;
  run.scores = {score_of("a", {"identical"}), score_of("b", {"dark", "identical"})};
  const auto warnings = shared_warnings(run);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].text, "identical");
  EXPECT_THAT(warnings[0].about, ElementsAre("room/a isr against truth", "room/b isr against truth"));
  EXPECT_EQ(about_text(warnings[1]), "room/b isr against truth");
}

TEST(SharedWarnings, AreTakenFromAllPartsOfTheReport) {
  RunReport run;
  run.warnings = {"of the run"};
  run.scenes.emplace_back().name = "room";
  run.scenes[0].warnings = {"of the scene"};
  ReportImage& image = run.images.emplace_back();
  image.scene = "room", image.view = "a", image.source = "isr", image.warnings = {"of the picture"};
  std::vector<std::string> texts;
  for (const SharedWarning& warning : shared_warnings(run))
    texts.push_back(about_text(warning) + ": " + warning.text);
  EXPECT_THAT(texts, ElementsAre(": of the run", "room: of the scene", "room/a isr: of the picture"));
}

TEST(SharedWarnings, NameThreePlacesAndCountTheOthers) {
  RunReport run;
  for (const char* view : {"a", "b", "c", "d", "e"}) run.scores.push_back(score_of(view, {"identical"}));
  EXPECT_EQ(about_text(shared_warnings(run).at(0)),
            "room/a isr against truth, room/b isr against truth, room/c isr against truth and 2 more");
}

TEST(SharedWarnings, OfARunWithoutAnyAreNone) {
  EXPECT_THAT(shared_warnings({}), IsEmpty());
}

}  // namespace
}  // namespace lightbench
