#include "scene/material_overrides.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using ::testing::HasSubstr;

class Overrides : public ::testing::Test {
 protected:
  Overrides() {
    for (const char* name : {"wall", "wall_2", "[wall]", "floor"}) materials_.emplace_back().name = name;
  }
  /// Names of the materials that become shiny, and all problems.
  std::string applied(const std::vector<std::string>& names) {
    ProblemList problems;
    {
      MaterialOverrides overrides(materials_, {"unused_wall"}, problems, "s.json: $.materials");
      MaterialPatch shiny;
      shiny.specular = 1;
      for (const std::string& name : names) overrides.apply(name, shiny, "here");
    }
    std::string text;
    for (const Material& material : materials_)
      if (material.specular == 1) text += material.name + " ";
    for (const Problem& problem : problems.all()) text += problem.what + "; ";
    return text;
  }
  std::vector<Material> materials_;
};

TEST_F(Overrides, ANameIsThatNameAndElseAPattern) {
  EXPECT_EQ(applied({"wall"}), "wall ");
  EXPECT_EQ(applied({"[wall]"}), "wall [wall] ");
}

TEST_F(Overrides, APatternMeansAllThatMatch) {
  EXPECT_EQ(applied({"wall*"}), "wall wall_2 ");
}

TEST_F(Overrides, WhatNoFaceHasIsANote) {
  EXPECT_EQ(applied({"unused_wall", "unused*"}),
            "no face has the material 'unused_wall'; no face has the material 'unused*'; ");
}

TEST_F(Overrides, AnUnknownNameIsAnErrorWithTheNearest) {
  EXPECT_EQ(applied({"flor", "zzz*"}),
            "no model has the material 'flor' (did you mean 'floor'?); no material matches 'zzz*'; ");
}

TEST_F(Overrides, ABackslashMakesNoPattern) {
  materials_.emplace_back().name = "old\\door";
  EXPECT_EQ(applied({"old\\dor"}), "no model has the material 'old\\dor' (did you mean 'old\\door'?); ");
  EXPECT_EQ(applied({"old\\door"}), "old\\door ");
}

TEST_F(Overrides, OfManyUnknownNamesTheFirstAreListed) {
  std::vector<std::string> names;
  for (int i = 0; i < 100; ++i) names.push_back("unknown " + std::to_string(i));
  EXPECT_THAT(applied(names), HasSubstr("95 more materials that no model has; "));
}

}  // namespace
}  // namespace lightbench
