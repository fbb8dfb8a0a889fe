#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "base/files.h"
#include "scene/problem_list.h"
#include "scene/scene_file.h"

namespace lightbench {

/// A folder of files that a test writes and loads.
class SceneTestFiles {
 public:
  std::filesystem::path write(const std::string& name, std::string_view text) const {
    const std::filesystem::path file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_{"lightbench-scene-test"};
};

/// All problems as lines "error where: what", with folders taken off.
inline std::string described(const std::vector<Problem>& problems, const std::filesystem::path& folder) {
  constexpr const char* kNames[] = {"error ", "warning ", "note "};
  std::string text;
  for (const Problem& p : problems) text += kNames[int(p.severity)] + p.where + ": " + p.what + "\n";
  const std::string prefix = folder.string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != text.npos;) text.erase(at, prefix.size());
  return text;
}

inline std::string described(const LoadedScene& loaded, const SceneTestFiles& files) {
  return described(loaded.problems, files.path("").parent_path());
}

inline std::size_t error_count(const LoadedScene& loaded) {
  return std::size_t(std::count_if(loaded.problems.begin(), loaded.problems.end(),
                                   [](const Problem& p) { return p.severity == Problem::Severity::error; }));
}

/// A unit square in the plane z = 0, facing +z.
inline constexpr std::string_view kSquareObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

/// The scene of one square with more keys beside "entities", and more keys in the entity.
inline LoadedScene load_square(const SceneTestFiles& files, const std::string& keys,
                               const std::string& entity_keys = "") {
  files.write("m.obj", kSquareObj);
  return load_scene_collecting(files.write(
      "s.json", R"({"entities": [{"name": "e", "obj": "m.obj")" + entity_keys + "}]" + keys + "}"));
}

}  // namespace lightbench
