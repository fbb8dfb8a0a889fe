#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/view_options.h"
#include "pipeline/references.h"
#include "pipeline/tables.h"
#include "scene/motion.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

struct ExportParams {
  ViewOptions view;
  std::string kind = "povray";
  std::string preset;
  std::vector<std::string> params;
  std::string folder = "export";
};

ExitCode run_export(const ExportParams& params) {
  const ReferenceKind& kind = find_reference_kind(params.kind, "--kind");
  if (!kind.exports())
    throw Error("renders scenes itself: there is nothing to export", "--kind " + kind.name);
  const ImageSize size = parse_size(params.view.size);
  const ParamValues values =
      resolve_params(kind.params, kind.presets, params.preset.empty() ? kind.default_preset : params.preset,
                     parse_params(kind.params, params.params), "--preset");
  Scene scene = load_scene(params.view.scene);
  const auto exported = kind.make_export(scene);
  const std::filesystem::path folder = params.folder;
  for (const auto& name : exported->write_shared(folder)) std::printf("%s\n", (folder / name).c_str());
  for (const auto& view : chosen_views(params.view, scene)) {
    set_time(scene, view.time);
    const auto stem = folder / escape_file_name(view.name);
    exported->write_view({view, size.width, size.height, params.view.samples, values, {}}, stem);
    for (const auto& suffix : kind.view_suffixes(values)) std::printf("%s%s\n", stem.c_str(), suffix.c_str());
  }
  for (const auto& warning : exported->warnings()) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  return ExitCode::ok;
}

}  // namespace

void add_export_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<ExportParams>(app, "export", "Write a scene's views for an offline renderer",
                                          action, run_export, command);
  add_view_options(*command, params->view);
  command->add_option("--kind", params->kind, "Offline renderer: " + join(row_names(reference_kinds()), ", "))
      ->capture_default_str();
  command->add_option("--preset", params->preset, "Named set of parameters (lightbench list params)");
  command->add_option("-p,--param", params->params, "NAME=VALUE; may stand several times")
      ->allow_extra_args(false);
  command->add_option("-o,--output", params->folder, "Folder to write to")->capture_default_str();
  command->footer(
      R"(All views of the camera script are written unless --view names one. The meshes and images that
they share are written once.

Example:
  lightbench export room.json --cameras room-cameras.json -o room-pov)");
}

}  // namespace lightbench
