#include "scene/named_files.h"

#include <gtest/gtest.h>

#include "scene_test_files.h"

namespace lightbench {
namespace {

class NamedFilesTest : public ::testing::Test {
 protected:
  /// The file found for a name, relative to the folder, with '*' where it is found elsewhere; "-" for none.
  std::string found(const std::string& name) {
    const auto file = named_.find(name, files_.path(""));
    if (!file) return "-";
    return file->file.lexically_relative(files_.path("")).string() + (file->found_elsewhere ? "*" : "");
  }
  SceneTestFiles files_;
  NamedFiles named_;
};

TEST_F(NamedFilesTest, TheFileOfThatNameComesFirst) {
  files_.write("Wood.png", "");
  files_.write("wood.png", "");
  EXPECT_EQ(found("wood.png"), "wood.png");
  EXPECT_EQ(found("\"wood.png\""), "wood.png");
}

TEST_F(NamedFilesTest, CaseIsForgivenInEachComponent) {
  files_.write("Textures/Wood.PNG", "");
  EXPECT_EQ(found("textures\\wood.png"), "Textures/Wood.PNG*");
  EXPECT_EQ(found("TEXTURES/../textures/WOOD.png"), "Textures/Wood.PNG*");
}

TEST_F(NamedFilesTest, OfSeveralThatDifferInCaseTheFirstInOrderIsTaken) {
  files_.write("wOOD.png", "");
  files_.write("WOOD.png", "");
  EXPECT_EQ(found("wood.PNG"), "WOOD.png*");
}

TEST_F(NamedFilesTest, APathOfAnotherMachineIsLookedForBesides) {
  files_.write("wood.png", "");
  EXPECT_EQ(found("C:\\Users\\me\\wood.png"), "wood.png*");
  EXPECT_EQ(found("/nowhere/Wood.png"), "wood.png*");
}

TEST_F(NamedFilesTest, WhatIsNotThereIsNothing) {
  files_.write("folder/wood.png", "");
  for (const char* name : {"", "wood.png", "folder", "folder/", "nowhere/x.png"})
    EXPECT_EQ(found(name), "-") << name;
}

TEST_F(NamedFilesTest, AFolderIsListedOnce) {
  files_.write("a.png", "");
  EXPECT_EQ(found("B.png"), "-");
  files_.write("b.png", "");
  EXPECT_EQ(found("B.png"), "-") << "the folder was listed again";
  EXPECT_EQ(found("b.png"), "b.png");
}

class NamesOnLine : public NamedFilesTest {
 protected:
  std::vector<std::string> names(const std::string& line) const {
    return names_on_line(line, files_.path(""), ".mtl");
  }
  using Names = std::vector<std::string>;
};

TEST_F(NamesOnLine, AreSeparatedByBlanks) {
  files_.write("a.mtl", "");
  files_.write("b", "");
  EXPECT_EQ(names("a.mtl  b\ta.mtl"), (Names{"a.mtl", "b", "a.mtl"}));
  EXPECT_EQ(names(""), (Names{""}));
}

TEST_F(NamesOnLine, EndAtAComment) {
  EXPECT_EQ(names("banana.mtl # materials"), (Names{"banana.mtl"}));
}

TEST_F(NamesOnLine, OfTooManyWordsAreOneName) {
  std::string line;
  for (int i = 0; i < 1000; ++i) line += "a ";
  ASSERT_EQ(names(line).size(), 1u);
  EXPECT_LE(names(line)[0].size(), 100u);
}

TEST_F(NamesOnLine, HaveTheBlanksOfFilesThatAreThere) {
  files_.write("my  own.mtl", "");
  files_.write("own.mtl", "");
  EXPECT_EQ(names("my  own.mtl"), (Names{"my  own.mtl"}));
  EXPECT_EQ(names("own.mtl my  own.mtl own.mtl"), (Names{"own.mtl", "my  own.mtl", "own.mtl"}));
  EXPECT_EQ(names("own.mtl \"my  own.mtl\""), (Names{"own.mtl", "\"my  own.mtl\""}));
}

TEST_F(NamesOnLine, ThatAreMissingEndWithTheExtensionOrBeforeOneThatIsThere) {
  files_.write("red.mtl", "");
  EXPECT_EQ(names("gone.mtl red.mtl"), (Names{"gone.mtl", "red.mtl"}));
  EXPECT_EQ(names("red.mtl gone.MTL lost.mtl"), (Names{"red.mtl", "gone.MTL", "lost.mtl"}));
  EXPECT_EQ(names("gone red.mtl"), (Names{"gone", "red.mtl"}));
  EXPECT_EQ(names("C:\\my things\\gone.mtl"), (Names{"C:\\my things\\gone.mtl"}));
}

}  // namespace
}  // namespace lightbench
