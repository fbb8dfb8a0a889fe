#include <filesystem>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/file_clashes.h"
#include "base/files.h"
#include "base/text.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/view_options.h"
#include "pipeline/console.h"
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

std::filesystem::path view_stem(const ExportParams& params, const View& view) {
  return std::filesystem::path(params.folder) / escape_file_name(view.name);
}

/// All that will be written.
std::vector<NamedFile> output_files(const ExportParams& params, const SceneExport& exported,
                                    const std::vector<View>& views,
                                    const std::vector<std::string>& suffixes) {
  std::vector<NamedFile> files;
  for (const auto& name : exported.shared_files())
    files.push_back({name, std::filesystem::path(params.folder) / name});
  for (const auto& view : views)
    for (const auto& suffix : suffixes)
      files.push_back({"view '" + view.name + "'", view_stem(params, view).string() + suffix});
  return files;
}

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
  const auto views = chosen_views(params.view, scene);
  const auto outputs = output_files(params, *exported, views, kind.view_suffixes(values));
  check_outputs(outputs, input_files(params.view, scene));
  exported->write_shared(params.folder);
  for (const auto& view : views) {
    set_time(scene, view.time);
    exported->write_view({view, size.width, size.height, params.view.samples, values, {}},
                         view_stem(params, view));
  }
  for (const auto& file : outputs) say(file.path.string());
  print_warnings(exported->warnings());
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
