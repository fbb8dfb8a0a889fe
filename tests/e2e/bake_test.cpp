// Command bake, and what command render makes of its folder.
#include "baked_fixture.h"

namespace lightbench {
namespace {

using test::Baked;
using test::GlBaked;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(Baked, AnObjectIsAFile) {
  const auto result = bake();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(files("baked"), ElementsAre("baked/0000-box.mtex", "baked/0001-floor.mtex", "baked/bake.json"));
}

TEST_F(Baked, WhatIsThereAlreadyIsKept) {
  bake();
  const std::string floor = read_file(path("baked/0001-floor.mtex"));
  write("baked/0000-box.mtex", "as it was");
  std::filesystem::remove(path("baked/0001-floor.mtex"));
  const auto result = bake();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("0000-box: there already\n0001-floor: "));
  EXPECT_EQ(read_file(path("baked/0000-box.mtex")), "as it was");
  EXPECT_EQ(read_file(path("baked/0001-floor.mtex")), floor);
}

TEST_F(Baked, AKilledBakeLeavesNoHalfWrittenFileAndGoesOn) {
  bake();
  const std::string box = read_file(path("baked/0000-box.mtex"));
  const std::string floor = read_file(path("baked/0001-floor.mtex"));
  ASSERT_LT(box.size(), kKilledAt) << "so that the bake is killed at the second object";
  ASSERT_GT(floor.size(), kKilledAt);
  std::filesystem::remove_all(path("baked"));
  EXPECT_EQ(bake_that_is_killed().signal, SIGXFSZ);
  EXPECT_EQ(read_file(path("baked/0000-box.mtex")), box);
  EXPECT_FALSE(std::filesystem::exists(path("baked/0001-floor.mtex")));
  EXPECT_THAT(bake().out, HasSubstr("0000-box: there already"));
  EXPECT_EQ(read_file(path("baked/0001-floor.mtex")), floor);
  EXPECT_EQ(files("baked").size(), 3u) << "nothing of the killed bake is left";
}

TEST_F(Baked, ABakeThatWasKilledBeforeItsFirstFileGoesOn) {
  write("baked/.bake.tmp-7-0.json", "half");
  write("baked/.0000-box.tmp-7-1.mtex", "half");
  const auto result = bake();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(files("baked"), ElementsAre("baked/0000-box.mtex", "baked/0001-floor.mtex", "baked/bake.json"));
}

TEST_F(Baked, ASecondBakeIsKeptOut) {
  std::filesystem::create_directory(path("baked"));
  const FolderLock another(path("baked"));
  const auto result = bake();
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("another bake is working in this folder"));
}

TEST_F(Baked, AFolderOfOtherParametersIsRefused) {
  bake();
  const std::string box = read_file(path("baked/0000-box.mtex"));
  const auto result = bake({"-p", "seed=2"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err,
            "lightbench: error: baked: holds objects that were baked from another scene or with other "
            "parameters: choose another folder, or remove it first\n");
  EXPECT_EQ(read_file(path("baked/0000-box.mtex")), box);
}

TEST_F(Baked, HowItWillBeDrawnIsNoOtherBake) {
  bake();
  EXPECT_EQ(bake({"-p", "codec=pca"}).exit_code, 0);
}

TEST_F(Baked, AFolderOfAnotherSceneIsRefused) {
  bake();
  write("box.mtl", "newmtl grey\nKd 0.1 0.5 0.4\n");
  const auto result = bake();
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("another scene"));
}

TEST_F(Baked, AFolderOfOtherFilesIsRefused) {
  write("baked/holiday.txt", "sun");
  const auto result = bake();
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("baked: is not empty, and not a folder that 'lightbench bake' made"));
}

TEST_F(Baked, AFileInThePlaceOfTheFolderIsAnError) {
  write("baked", "a file");
  const auto result = bake();
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("error: baked: cannot make the folder"));
}

TEST_F(Baked, ASizeOfAnUnknownObjectIsAnErrorWithTheNearest) {
  const auto result = bake({"-p", "sizes=flor=8x8"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("has no object 'flor' (did you mean 'floor'?)"));
  EXPECT_FALSE(std::filesystem::exists(path("baked")));
  EXPECT_EQ(bake({"-p", "sizes=fl*=8x8"}).exit_code, 0);
}

TEST_F(GlBaked, RenderDrawsWhatWasBaked) {
  bake();
  const auto result = draw("baked.exr");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("warning")));
  run({"render", "scene.json", "--cameras", "cameras.json", "--view", "front", "--size", "32x24", "-o",
       "direct.exr"});
  // Shadows are as coarse as the texels, two to a unit; nothing lit, or all of it black, differs by 60.
  EXPECT_LT(mean_difference("baked.exr", "direct.exr"), 8);
}

TEST_F(GlBaked, AnObjectThatIsNotThereIsAnError) {
  bake();
  std::filesystem::remove(path("baked/0001-floor.mtex"));
  const auto result = draw("baked.exr");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("baked/0001-floor.mtex: cannot read the file: No such file"));
  EXPECT_FALSE(std::filesystem::exists(path("baked.exr")));
}

TEST_F(GlBaked, AnObjectThatWasCutShortIsAnError) {
  bake();
  std::filesystem::resize_file(path("baked/0000-box.mtex"), 100);
  const auto result = draw("baked.exr");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("baked/0000-box.mtex: has 100 bytes, but "));
}

TEST_F(GlBaked, AFolderThatBakeDidNotMakeIsAnError) {
  const auto result = draw("baked.exr");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("baked: is not a folder that 'lightbench bake' made"));
}

TEST_F(GlBaked, ASceneThatChangedSinceIsAWarning) {
  bake();
  write("box.mtl", "newmtl grey\nKd 0.1 0.5 0.4\n");
  const auto result = draw("baked.exr");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("warning: baked: was baked from another scene"));
}

}  // namespace
}  // namespace lightbench
