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

}  // namespace
}  // namespace lightbench
