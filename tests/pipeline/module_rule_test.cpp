#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "base/files.h"

namespace lightbench {
namespace {

const std::filesystem::path kRoot = LIGHTBENCH_SOURCE_DIR;

/// Which of our folders each folder may include.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"base", {"base"}},
    {"scene", {"base", "scene"}},
    {"renderer", {"base", "scene", "renderer"}},
    {"povexport", {"base", "scene", "povexport"}},
    {"reports", {"base", "reports"}},
    {"pipeline", {"base", "scene", "renderer", "povexport", "reports", "pipeline"}},
};

std::vector<std::filesystem::path> sources_of(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot / folder))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") files.push_back(entry.path());
  return files;
}

std::vector<std::string> includes_of(const std::filesystem::path& file) {
  static const std::regex include(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])", std::regex::multiline);
  const std::string text = read_file(file);
  std::vector<std::string> result;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), include); match != std::sregex_iterator();
       ++match)
    result.push_back((*match)[1]);
  return result;
}

class ModuleRule : public ::testing::TestWithParam<std::string> {};

TEST_P(ModuleRule, AFolderIncludesOnlyWhatItMay) {
  const auto files = sources_of(GetParam());
  EXPECT_FALSE(files.empty());
  for (const auto& file : files)
    for (const auto& include : includes_of(file)) {
      const std::string folder = include.substr(0, include.find('/'));
      if (!kMayInclude.contains(folder)) continue;
      EXPECT_TRUE(kMayInclude.at(GetParam()).contains(folder)) << file << " includes " << include;
    }
}

TEST_P(ModuleRule, OpenGlAndEmbreeStayInTheRenderer) {
  if (GetParam() == "renderer") return;
  for (const auto& file : sources_of(GetParam()))
    for (const auto& include : includes_of(file))
      for (const char* library : {"GL/", "EGL/", "glad/", "embree"})
        EXPECT_FALSE(include.starts_with(library)) << file << " includes " << include;
}

/// Parts of the one reading path of pictures, which only its sources include.
const std::set<std::string> kInside = {"base/picture_file.h", "base/picture_pixels.h"};

TEST_P(ModuleRule, NobodyElseIncludesWhatIsInsideAPath) {
  for (const auto& file : sources_of(GetParam())) {
    if (GetParam() == "base" && file.extension() == ".cpp") continue;
    for (const auto& include : includes_of(file))
      EXPECT_FALSE(kInside.contains(include)) << file << " includes " << include;
  }
}

TEST_P(ModuleRule, HeadersDoNotDrawInHeavyLibraries) {
  for (const auto& file : sources_of(GetParam())) {
    if (file.extension() != ".h" || kInside.contains(file.lexically_relative(kRoot).generic_string()))
      continue;
    for (const auto& include : includes_of(file)) {
      EXPECT_NE(include, "nlohmann/json.hpp") << file;
      EXPECT_FALSE(include.starts_with("OpenImageIO/")) << file;
      EXPECT_NE(include, "CLI/CLI.hpp") << file;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Folders, ModuleRule,
                         ::testing::Values("base", "scene", "renderer", "povexport", "reports", "pipeline"),
                         [](const auto& folder) { return folder.param; });

}  // namespace
}  // namespace lightbench
