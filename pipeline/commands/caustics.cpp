#include <array>
#include <thread>

#include <CLI/CLI.hpp>

#include "base/file_clashes.h"
#include "base/files.h"
#include "pipeline/caustics_study.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_range.h"
#include "pipeline/commands/usage_errors.h"
#include "pipeline/console.h"
#include "pipeline/snapshot.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

struct CausticsParams {
  std::vector<std::string> scenes;
  CausticsStudyOptions options;
  float amplitudes = 1;  ///< by how much the waves are higher than the scenes say
  std::string output;
};

ExitCode run_caustics(const CausticsParams& params) {
  CausticsStudyOptions options = params.options;
  options.threads = int(std::max(1u, std::thread::hardware_concurrency()));
  const std::array outputs{NamedFile{"-o", params.output}};
  check_outputs(outputs, named("a scene", std::vector<std::filesystem::path>(params.scenes.begin(),
                                                                             params.scenes.end())));
  if (!params.output.empty()) require_writable(params.output);
  std::vector<std::pair<std::string, std::vector<ReceiverFigures>>> figures;
  for (const std::string& file : params.scenes) {
    Scene scene = load_scene(file);
    check_outputs(outputs, named("a file of the scene", file_paths(scene)));
    if (scene.water)
      for (Wave& wave : scene.water->waves) wave.amplitude *= params.amplitudes;
    figures.emplace_back(scene.name, study_caustics(scene, options, say_aside));
  }
  const std::string tables = caustics_tables(figures, options.maps.slices);
  if (params.output.empty())
    say(tables);
  else
    write_file_atomic(params.output, tables);
  return ExitCode::ok;
}

}  // namespace

void add_caustics_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<CausticsParams>(
      app, "caustics", "Compare the maps of technique caustics with rays from the lights", action,
      run_caustics, command);
  CausticsStudyOptions& options = params->options;
  command->add_option("scene", params->scenes, "Scene files with water")->required();
  command->add_option("--rays", options.rays, "Of each light, through the water; about so many")
      ->check(number_between(1000.0, 1e11))
      ->capture_default_str();
  command->add_option("--map-size", options.maps.size, "Texels along an edge of a receiver's maps")
      ->check(number_between(16, 4096))
      ->capture_default_str();
  command->add_option("--slices", options.maps.slices, "Of a receiver's box")
      ->check(number_between(1, 2000))
      ->capture_default_str();
  command
      ->add_option("--layers", options.maps.layers,
                   "Of the position map: with 2, edges stop light that is bent aside")
      ->check(number_between(1, 2))
      ->capture_default_str();
  const std::vector<std::string> names = caustics_method_names();
  command->add_option("--methods", options.methods, "Only these; default: all")
      ->check(one_of(names))
      ->expected(1, int(names.size()));
  command->add_option("--most", options.most, "Flat water's light: brighter texels count as so bright")
      ->check(number_between(0.01, 1e6))
      ->capture_default_str();
  command
      ->add_option("--amplitudes", params->amplitudes,
                   "Waves that are so many times as high as in the scenes")
      ->check(number_between(0.0, 100.0))
      ->capture_default_str();
  command->add_flag("--povray", options.povray, "POV-Ray's photons, too: about a minute a receiver");
  command
      ->add_option("--photon-spacing", options.photon_spacing,
                   "Between POV-Ray's photons, as a share of the water's longer side; half of it takes four "
                   "times the time and memory (0.2 GB by default)")
      ->check(number_between(1e-5, 0.1))
      ->capture_default_str();
  command->add_option("-o,--output", params->output, "Markdown file to write; default: print it");
  command->footer(
      R"(Two Markdown tables. Of each receiver: the map's texels that show it, the water's triangles that
let light in, those whose light may reach it and that are drawn, those whose light runs across the axis of its box and
that no map shows, the planes that it lies on, and fragments of folded triangles whose area was raised to the least. Of
each method: the correlation of its flux with that of the rays (after a mean over 3 x 3 texels, and clipped), the light
over that of the rays, the light over what enters the water, the texels with other bits than the first method's, and
what textures took at a time.

Example:
  lightbench caustics pool.json --rays 10000000)");
}

}  // namespace lightbench
