#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "scene/camera_script.h"
#include "scene/scene_file.h"

// The scene files and camera scripts that lightbench comes with.
namespace lightbench {
namespace {

namespace fs = std::filesystem;

const fs::path kJobs = fs::path(LIGHTBENCH_SOURCE_DIR) / "jobs";

// "office" and "rooms/office" for office.json and rooms/office.json below a folder of jobs/. The line-up's
// scenes are not among them: they have their views in jobs/lineup.json and are tested by tests/agreement.
std::vector<std::string> names_below(const std::string& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kJobs / folder))
    if (entry.path().extension() == ".json" && entry.path().parent_path().filename() != "lineup")
      names.push_back(fs::relative(entry.path(), kJobs / folder).replace_extension().generic_string());
  std::sort(names.begin(), names.end());
  return names;
}

fs::path scene_file(const std::string& name) {
  return kJobs / "scenes" / (name + ".json");
}
fs::path camera_file(const std::string& name) {
  return kJobs / "cameras" / (name + ".json");
}

// The variable that the scene's models are found through and that names no folder, or nothing.
std::string missing_variable(const std::string& name) {
  const std::string text = read_file(scene_file(name));
  for (const char* variable : {"LIGHTBENCH_SCENES", "LIGHTBENCH_FURNITURE"}) {
    if (text.find(std::string("${") + variable + "}") == std::string::npos) continue;
    const char* folder = std::getenv(variable);
    if (!folder || !fs::is_directory(folder)) return variable;
  }
  return "";
}

bool must_be_there(const std::string& variable) {
  const char* required = std::getenv("LIGHTBENCH_REQUIRE_SCENES");
  return variable == "LIGHTBENCH_SCENES" && required && std::string(required) == "1";
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

class JobsScene : public testing::TestWithParam<std::string> {};

TEST_P(JobsScene, LoadsWithoutErrors) {
  const std::string variable = missing_variable(GetParam());
  ASSERT_FALSE(must_be_there(variable)) << variable << " names no folder, and LIGHTBENCH_REQUIRE_SCENES is 1";
  if (!variable.empty()) GTEST_SKIP() << GetParam() << " needs the folder that " << variable << " names";
  const LoadedScene loaded = load_scene_collecting(scene_file(GetParam()));
  for (const Problem& problem : loaded.problems)
    EXPECT_NE(problem.severity, Problem::Severity::error) << problem.where << ": " << problem.what;
  EXPECT_FALSE(loaded.scene.lights.empty());
  EXPECT_GT(triangle_count(loaded.scene), 0u);
}

// Of its own, or of all scenes in its folder.
TEST_P(JobsScene, HasACameraScript) {
  const std::string folder = fs::path(GetParam()).parent_path().generic_string();
  EXPECT_TRUE(fs::exists(camera_file(GetParam())) || (!folder.empty() && fs::exists(camera_file(folder))));
}

INSTANTIATE_TEST_SUITE_P(All, JobsScene, testing::ValuesIn(names_below("scenes")), test_name);

class JobsCameras : public testing::TestWithParam<std::string> {};

constexpr std::string_view kDrawn = "_random";

TEST_P(JobsCameras, HasAtLeastTwoViews) {
  const std::size_t least = GetParam().ends_with(kDrawn) ? 1 : 2;  // one was drawn beside those of the scene
  EXPECT_GE(read_camera_script(camera_file(GetParam())).size(), least);
}

TEST_P(JobsCameras, BelongsToAScene) {
  std::string scene = GetParam();
  if (scene.ends_with(kDrawn)) scene.resize(scene.size() - kDrawn.size());
  EXPECT_TRUE(fs::exists(scene_file(scene)) || fs::is_directory(kJobs / "scenes" / scene));
}

INSTANTIATE_TEST_SUITE_P(All, JobsCameras, testing::ValuesIn(names_below("cameras")), test_name);

// A room of furniture must say who made the pieces: most of the licences ask for it.
TEST(JobsRooms, NameTheMakersOfTheirFurniture) {
  for (const std::string& name : names_below("scenes")) {
    if (name.rfind("rooms/", 0) != 0) continue;
    const LoadedScene loaded = load_scene_collecting(scene_file(name));
    EXPECT_FALSE(loaded.scene.credits.empty()) << name;
    for (const Credit& credit : loaded.scene.credits)
      EXPECT_FALSE(credit.creator.empty() || credit.license.empty()) << name << ": " << credit.piece;
  }
}

}  // namespace
}  // namespace lightbench
