#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace lightbench {

/// Something wrong, or worth knowing, about a scene.
struct Problem {
  enum class Severity { error, warning, note };
  Severity severity = Severity::error;
  std::string what;
  std::string where;  ///< file:line or file: $.json.path
};

/// A scene and everything that was found while reading it. With any problem of severity `error` the scene is
/// incomplete and must not be rendered.
struct LoadedScene {
  Scene scene;
  std::vector<Problem> problems;
};

/// Reads a scene file (.json, jobs/FORMAT.md) or a bare OBJ, which gets the default light. Never throws for
/// what is wrong inside the files: all of it is listed.
LoadedScene load_scene_collecting(const std::filesystem::path& file);

/// The same for those who want to render: throws Error for the first problem of severity `error`, and keeps
/// the warnings in Scene::warnings.
Scene load_scene(const std::filesystem::path& file);

}  // namespace lightbench
