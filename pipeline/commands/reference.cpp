#include <array>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/error.h"
#include "base/file_clashes.h"
#include "base/files.h"
#include "base/text.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_range.h"
#include "pipeline/commands/view_options.h"
#include "pipeline/console.h"
#include "pipeline/references.h"
#include "pipeline/snapshot.h"
#include "pipeline/tables.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

struct ReferenceParams {
  ViewOptions view;
  std::string kind = "povray";
  std::string preset;
  std::vector<std::string> params;
  double timeout = 7200;
  std::string output = "reference.exr";
};

ReferenceImage render_export(const ReferenceKind& kind, const ReferenceRequest& request, const Scene& scene) {
  const auto exported = kind.make_export(scene);
  const TemporaryFolder folder;
  const auto stem = folder.path() / "view";
  exported->write_shared(folder.path());
  exported->write_view(request, stem);
  print_warnings(exported->warnings());
  return kind.run_export(request, {stem, folder.path()});
}

ExitCode run_reference(const ReferenceParams& params) {
  const std::filesystem::path output = params.output;
  check_picture_name(output);
  const ReferenceKind& kind = find_reference_kind(params.kind, "--kind");
  const std::string version = kind.tool_version();
  const ImageSize size = parse_size(params.view.size);
  const ParamValues values =
      resolve_params(kind.params, kind.presets, params.preset.empty() ? kind.default_preset : params.preset,
                     parse_params(kind.params, params.params), "--preset");
  Scene scene = load_scene(params.view.scene);
  check_outputs(std::array{NamedFile{"-o", output}}, input_files(params.view, scene));
  require_writable(output);  // rather than after minutes of rendering
  const View view = chosen_view(params.view, scene);
  const ReferenceRequest request{view,        size.width,
                                 size.height, params.view.samples,
                                 values,      std::chrono::milliseconds(std::llround(params.timeout * 1000))};
  const ReferenceImage made =
      kind.exports() ? render_export(kind, request, scene) : kind.run_scene(request, scene);
  print_warnings(made.warnings);
  print_warnings(write_picture(output, made.image));
  say(fmt::format("{}: {:.1f} s ({:.1f} s of processor time)", version, made.seconds, made.cpu_seconds));
  for (const auto& [name, rate] : made.ray_rates)
    say(fmt::format("{} rays: {:.2f} million a second", name, rate / 1e6));
  if (made.noise) say(fmt::format("estimated error: {:.3f} of 255", *made.noise));
  say(output.string());
  return ExitCode::ok;
}

}  // namespace

void add_reference_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<ReferenceParams>(
      app, "reference", "Render one view of a scene offline: the truth", action, run_reference, command);
  add_view_options(*command, params->view);
  command->add_option("--kind", params->kind, "Offline renderer: " + join(row_names(reference_kinds()), ", "))
      ->capture_default_str();
  command->add_option("--preset", params->preset, "Named set of parameters (lightbench list params)");
  command->add_option("-p,--param", params->params, "NAME=VALUE; may stand several times")
      ->allow_extra_args(false);
  command->add_option("--timeout", params->timeout, "Seconds after which it is stopped")
      ->check(number_between(0.1, 1e7))
      ->capture_default_str();
  command->add_option("-o,--output", params->output, ".png (8-bit sRGB) or .exr (linear, alpha is coverage)")
      ->capture_default_str();
  command->footer(R"(Example:
  lightbench reference room.json --cameras room-cameras.json --view door --preset direct -o door-truth.exr)");
}

}  // namespace lightbench
