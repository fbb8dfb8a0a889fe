#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/error.h"
#include "base/file_clashes.h"
#include "base/text.h"
#include "pipeline/bake_folder.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/view_options.h"
#include "pipeline/console.h"
#include "pipeline/snapshot.h"
#include "pipeline/tables.h"
#include "renderer/renderer.h"
#include "renderer/techniques/images.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

struct RenderParams {
  ViewOptions view;
  std::string technique = "direct";
  std::string preset;
  std::vector<std::string> params;
  std::string baked;
  std::string output = "out.png";
  std::vector<std::string> buffers;
  std::string gl = "osmesa";
};

std::filesystem::path buffer_file(std::filesystem::path output, const std::string& name,
                                  const char* extension) {
  return output.replace_extension().string() + "." + name + extension;
}

/// The picture that a technique shows instead of drawing one.
NamedFile shown_picture(const Technique& technique, const ParamValues& values, const Scene& scene,
                        const View& view) {
  return {"the picture to show",
          technique.external ? picture_path(values.text("pattern"), scene.name, view.name) : ""};
}

void check_written_files(const RenderParams& params, const Scene& scene, const NamedFile& picture) {
  std::vector<NamedFile> outputs = {{"-o", params.output}};
  for (const auto& name : params.buffers)
    for (const char* extension : {".exr", ".png"})
      outputs.push_back({"buffer " + name, buffer_file(params.output, name, extension)});
  std::vector<NamedFile> inputs = input_files(params.view, scene);
  inputs.push_back(picture);
  check_outputs(outputs, inputs);
}

/// Nothing where no folder is given.
BakeFolder baked_objects(const Technique& technique, const RenderParams& params) {
  if (params.baked.empty()) return {};
  if (!technique.needs_bake)
    throw Error("technique '" + technique.name + "' draws nothing that was baked", "--baked");
  return read_bake_folder(params.baked);
}

/// Those of the command line; what was baked says how, where nothing else is given.
GivenParams given_params(const Technique& technique, const RenderParams& params, const BakeFolder& baked) {
  GivenParams given = parse_params(technique.params, params.params);
  given.insert(baked.params.begin(), baked.params.end());
  return given;
}

/// What fits is drawn all the same: it may be meant.
void warn_of_another_scene(const Scene& scene, const ParamValues& values, const RenderParams& params,
                           const BakeFolder& baked) {
  if (!params.baked.empty() && baked.key != bake_folder(scene, values).key)
    warn(params.baked + ": was baked from another scene, from other files of it, or by another version");
}

ExitCode run_render(const RenderParams& params) {
  const std::filesystem::path output = params.output;
  check_picture_name(output);
  const Technique& technique = find_technique(params.technique, "--technique");
  const BakeFolder baked = baked_objects(technique, params);
  const ParamValues values = resolve_params(technique.params, technique.presets, params.preset,
                                            given_params(technique, params, baked), "--preset");
  const ImageSize size = parse_size(params.view.size);
  Scene scene = load_scene(params.view.scene);
  print_warnings(scene.warnings);
  warn_of_another_scene(scene, values, params, baked);
  const View view = chosen_view(params.view, scene);
  check_written_files(params, scene, shown_picture(technique, values, scene, view));
  FrameRequest request{scene,
                       view,
                       size.width,
                       size.height,
                       params.view.samples,
                       {params.buffers.begin(), params.buffers.end()},
                       params.baked};
  Renderer renderer(parse_gl(params.gl, "--gl"));
  const FrameResult frame = renderer.render(technique, values, request);
  print_warnings(frame.warnings);
  print_warnings(write_picture(output, frame.image));
  for (const auto& [name, buffer] : frame.buffers)
    write_buffer_pair(buffer_file(output, name, ".exr"), buffer_file(output, name, ".png"), buffer);
  double total = 0;
  for (const auto& pass : frame.passes) {
    say(fmt::format("{:<24} {:8.2f} ms", pass.name, pass.seconds * 1000));
    total += pass.seconds;
  }
  say(fmt::format("{:<24} {:8.2f} ms\n{}", "all passes", total * 1000, output.string()));
  return ExitCode::ok;
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<RenderParams>(app, "render", "Render one view of a scene with one technique",
                                          action, run_render, command);
  add_view_options(*command, params->view);
  command
      ->add_option("-t,--technique", params->technique,
                   "How to light it: " + join(row_names(techniques()), ", "))
      ->capture_default_str();
  command->add_option("--preset", params->preset, "Named set of parameters (lightbench list params)");
  command->add_option("-p,--param", params->params, "NAME=VALUE; may stand several times")
      ->allow_extra_args(false);
  command->add_option("--baked", params->baked,
                      "Folder that 'lightbench bake' made, for technique surface_radiance");
  command->add_option("-o,--output", params->output, ".png (8-bit sRGB) or .exr (linear)")
      ->capture_default_str();
  command
      ->add_option("--buffers", params->buffers,
                   "Named buffers to write beside the output, e.g. albedo,normal")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--gl", params->gl, "OpenGL back end: osmesa or egl")->capture_default_str();
  command->footer(R"(Examples:
  lightbench render room.json --cameras room-cameras.json --view door -o door.png
  lightbench render model.obj --position 0 1 4 --look-at 0 1 0 -t isr --param samples=80 --buffers indirect)");
}

}  // namespace lightbench
