#include "pipeline/scene_facts_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace lightbench {
namespace {

SceneFacts full_facts() {
  SceneFacts facts;
  facts.triangles = 12;
  facts.texture_bytes = 4096;
  facts.light_points = 16;
  facts.moves = true;
  facts.warnings = {"bump maps are ignored", "caf\xE9.png is dark"};
  facts.credits = {{"chair", "someone", "CC0"}};
  facts.files = {{"a.obj", "1"}, {"a.obj", "2"}, {"caf\xE9.png", "3"}};
  facts.paths = {"/one/a.obj", "/two/a.obj", "/caf\xE9.png"};
  facts.unsupported = {{}, {"it shows no water", "entities move"}};
  facts.objects = {{3, "floor", "0003-floor"}};
  facts.sizes = {{}, {{1000.5, 400}}};
  facts.exports = {{{{"shared a.inc", "5"}, {"view", "6"}}, {}}, {}};
  facts.kind_warnings = {{"povray", {"a light is approximated"}}};
  return facts;
}

TEST(SceneFactsFile, KeepsAllThatPlanningNeeds) {
  const std::string text = scene_facts_to_json(full_facts());
  const SceneFacts read = scene_facts_from_json(text, "facts.json");
  EXPECT_EQ(scene_facts_to_json(read), text);
  EXPECT_EQ(read.files, full_facts().files);
  EXPECT_EQ(read.warnings, full_facts().warnings) << "names of files may have any bytes";
  EXPECT_EQ(read.exports, full_facts().exports);
  EXPECT_EQ(read.unsupported, full_facts().unsupported);
  EXPECT_EQ(read.sizes.at(1).at(0).texels, 1000.5);
  EXPECT_EQ(read.objects.at(0).file_stem, "0003-floor");
  EXPECT_EQ(read.credits.at(0).license, "CC0");
  EXPECT_EQ(read.kind_warnings, full_facts().kind_warnings);
  EXPECT_EQ(read.texture_bytes, 4096u);
  EXPECT_EQ(read.light_points, 16u);
  EXPECT_TRUE(read.moves);
}

TEST(SceneFactsFile, KeepsAnError) {
  SceneFacts facts;
  facts.error = "a.obj:3: too many";
  EXPECT_EQ(scene_facts_from_json(scene_facts_to_json(facts), "").error, facts.error);
}

TEST(SceneFactsFile, WhatIsNoSuchTextIsAnErrorWithItsPlace) {
  for (const char* text : {"", "{", "[]", "{}", R"({"error": 7})"}) {
    try {
      scene_facts_from_json(text, "facts.json");
      FAIL() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.where(), "facts.json");
    }
  }
}

}  // namespace
}  // namespace lightbench
