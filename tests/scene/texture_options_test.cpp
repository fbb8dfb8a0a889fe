#include "scene/texture_options.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TextureStatement read(std::string_view text, const std::set<std::string>& files = {"t.png"}) {
  return read_texture_statement(text, [&](const std::string& name) { return files.contains(name); });
}

TEST(TextureOptions, TakeOneTwoOrThreeNumbers) {
  EXPECT_EQ(read("-s 2 t.png").placement.scale, glm::dvec2(2, 1));
  EXPECT_EQ(read("-s 2 3 t.png").placement.scale, glm::dvec2(2, 3));
  EXPECT_EQ(read("-s 2 3 4 t.png").placement.scale, glm::dvec2(2, 3));
  EXPECT_EQ(read("-o 0.5 t.png").placement.offset, glm::dvec2(0.5, 0));
  EXPECT_EQ(read("-o -.5 1e-1 0 t.png").placement.offset, glm::dvec2(-0.5, 0.1));
  for (const char* text : {"-s 2 t.png", "-s 2 3 t.png", "-t 0 t.png", "-mm 0 1 t.png", "-mm 0 t.png"})
    EXPECT_EQ(read(text).name, "t.png") << text;
}

TEST(TextureOptions, StopAtNamesThatHoldWordsForWhatIsNoNumber) {
  for (const char* name : {"banana.png", "C:\\tex\\finance.png", "info"}) {
    const auto statement = read(std::string("-s 2 2 ") + name);
    EXPECT_EQ(statement.name, name);
    EXPECT_EQ(statement.problem, "");
  }
}

TEST(TextureOptions, OfAllKindsMayStandInARow) {
  const auto statement = read(
      "-blendu off -blendv on -boost 2 -cc on -clamp off -imfchan m -mm 0 1 -texres 512 -bm 1 -t 0 0 0 "
      "-S 2 2 -o 1 1 1 sub folder/t.png");
  EXPECT_EQ(statement.name, "sub folder/t.png");
  EXPECT_EQ(statement.placement, (TexturePlacement{glm::dvec2(2), glm::dvec2(1)}));
  EXPECT_THAT(statement.unshown, IsEmpty());
}

TEST(TextureOptions, ThatChangeThePictureAreListed) {
  EXPECT_THAT(read("-t 0.1 -mm 0.2 1 -clamp on -imfchan r -type sphere t.png").unshown,
              ElementsAre("-t", "-mm", "-clamp", "-imfchan", "-type"));
}

TEST(TextureOptions, LeaveNamesThatLookLikeNumbers) {
  EXPECT_EQ(read("-s 2 2 7", {"7"}).name, "7");
  EXPECT_EQ(read("-s 2 2 7", {"7"}).placement.scale, glm::dvec2(2, 2));
  EXPECT_EQ(read("-s 2 3 trees.png", {"3 trees.png"}).name, "3 trees.png");
  EXPECT_EQ(read("-s 2 3 trees.png", {"3 trees.png"}).placement.scale, glm::dvec2(2, 1));
  EXPECT_EQ(read("-s 2 2 2 3.png", {"3.png"}).name, "3.png");
  EXPECT_EQ(read("7", {}).name, "7") << "a name that is missing, too";
}

TEST(TextureOptions, LeaveNamesThatBeginWithAMinus) {
  EXPECT_EQ(read("-s 2 -s.png", {"-s.png"}).name, "-s.png");
  EXPECT_EQ(read("-o 1.png", {"-o 1.png"}).name, "-o 1.png");
  EXPECT_EQ(read("-unknown t.png").name, "-unknown t.png") << "which is missing, and an error that names it";
}

TEST(TextureOptions, OfWordsMayLackThem) {
  EXPECT_EQ(read("-clamp t.png").name, "t.png");
  EXPECT_EQ(read("-type t.png").name, "t.png");
}

TEST(TextureOptions, AndCommentsBehindTheNameAreRead) {
  EXPECT_EQ(read("t.png -s 2 2 2").name, "t.png");
  EXPECT_EQ(read("t.png -s 2 2 2").placement.scale, glm::dvec2(2, 2));
  EXPECT_EQ(read("t.png # the floor").name, "t.png");
  EXPECT_EQ(read("a #1.png", {"a #1.png"}).name, "a #1.png");
}

TEST(TextureOptions, WithoutANameHaveNone) {
  EXPECT_EQ(read("").name, "");
  EXPECT_EQ(read("-s 1 1 1").name, "");
  EXPECT_EQ(read("-clamp on").name, "");
}

TEST(TextureOptions, ThatAreNotFiniteAreAProblem) {
  EXPECT_EQ(read("-s nan 1 t.png").problem, "-s has 'nan', which is no finite number");
  EXPECT_EQ(read("-o 1e999 t.png").problem, "-o has '1e999', which is no finite number");
}

TEST(TextureOptions, OfMillionsTakeNoTime) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += "-s 1 1 1 ";
  EXPECT_EQ(read(text + "t.png").name, "t.png");
}

}  // namespace
}  // namespace lightbench
