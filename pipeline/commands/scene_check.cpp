
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "pipeline/commands/commands.h"
#include "pipeline/console.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

struct SceneCheckParams {
  std::vector<std::string> scenes;
};

const char* severity_text(Problem::Severity severity) {
  switch (severity) {
    case Problem::Severity::error:
      return "error";
    case Problem::Severity::warning:
      return "warning";
    case Problem::Severity::note:
      return "note";
  }
  return "";
}

/// Whether the scene can be used.
bool check_scene(const std::string& file) {
  const LoadedScene loaded = load_scene_collecting(file);
  bool ok = true;
  for (const auto& problem : loaded.problems) {
    const std::string place = problem.where.empty() ? file : problem.where;
    say(fmt::format("{}: {}: {}", place, severity_text(problem.severity), problem.what));
    ok = ok && problem.severity != Problem::Severity::error;
  }
  const Scene& scene = loaded.scene;
  if (!ok) {
    say(file + ": cannot be used");
    return false;
  }
  const Bounds bounds = world_bounds(scene);
  say(fmt::format(
      "{}: fine: {} triangles, {} entities, {} materials, {} textures, {} lights, from ({:g} {:g} {:g}) to "
      "({:g} {:g} {:g})",
      file, triangle_count(scene), scene.entities.size(), scene.materials.size(), scene.textures.size(),
      scene.lights.size(), bounds.min.x, bounds.min.y, bounds.min.z, bounds.max.x, bounds.max.y,
      bounds.max.z));
  return true;
}

ExitCode run_scene_check(const SceneCheckParams& params) {
  bool ok = true;
  for (const auto& scene : params.scenes) ok = check_scene(scene) && ok;
  return ok ? ExitCode::ok : ExitCode::bad_input;
}

}  // namespace

void add_scene_command(CLI::App& app, Action& action) {
  CLI::App* scene = app.add_subcommand("scene", "Look at scene files");
  scene->require_subcommand(1);
  CLI::App* command = nullptr;
  auto params = add_command<SceneCheckParams>(*scene, "check", "List every problem of scenes at once", action,
                                              run_scene_check, command);
  command->add_option("scenes", params->scenes, "Scene files (.json) or OBJ files")->required();
  command->footer(
      R"(Each problem comes with its file and line or JSON path. Exit code 3 when a scene cannot be used.

Example:
  lightbench scene check jobs/scenes/*.json)");
}

}  // namespace lightbench
