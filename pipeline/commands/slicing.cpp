#include <algorithm>
#include <charconv>
#include <filesystem>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/files.h"
#include "pipeline/caustics_methods.h"
#include "pipeline/commands/busy.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_range.h"
#include "pipeline/commands/usage_errors.h"
#include "pipeline/console.h"
#include "pipeline/slicing_study.h"
#include "pipeline/snapshot.h"
#include "renderer/renderer.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

constexpr int kMostPlanes = 2001;

struct SlicingParams {
  std::vector<std::string> scenes;
  std::vector<std::string> planes{"11", "26", "51", "101"};
  SlicingStudyOptions options;
  std::string gl = "osmesa";
  std::string output;
};

int plane_count(std::string_view text, const std::string& where) {
  int planes = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), planes);
  if (error != std::errc() || end != text.data() + text.size() || planes < 2 || planes > kMostPlanes)
    throw Error("--planes: not a number from 2 to 2001, nor two of them as in 3..101", where);
  return planes;
}

/// Numbers, and ranges like 3..101, sorted.
std::vector<int> plane_counts(const std::vector<std::string>& texts) {
  std::vector<int> counts;
  for (const std::string& text : texts) {
    const std::size_t dots = text.find("..");
    const int first = plane_count(std::string_view(text).substr(0, dots), text);
    const int last =
        dots == std::string::npos ? first : plane_count(std::string_view(text).substr(dots + 2), text);
    for (int planes = first; planes <= last; ++planes) counts.push_back(planes);
  }
  std::sort(counts.begin(), counts.end());
  counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
  return counts;
}

ExitCode run_slicing(const SlicingParams& params) {
  SlicingStudyOptions options = params.options;
  options.planes = plane_counts(params.planes);
  if (options.planes.empty()) throw Error("--planes: the range is empty", params.planes.front());
  options.backend = parse_gl(params.gl, "--gl");
  const std::filesystem::path folder = params.output;
  require_writable((folder / "index.html").string());
  warn_if_busy();
  SlicingReport report;
  report.rounds = options.rounds;
  report.layers = options.layers;
  report.renderer = Renderer(options.backend).description();
  for (const std::string& file : params.scenes)
    for (SlicedReceiver& receiver : study_slicing(load_scene(file), options, say_aside))
      report.receivers.push_back(std::move(receiver));
  if (report.receivers.empty()) throw Error("no receiver is there to time", params.scenes.front());
  for (const ReportFile& written : slicing_files(report))
    write_file_atomic(folder / written.name, written.text);
  say((folder / "index.html").string());
  return ExitCode::ok;
}

}  // namespace

void add_slicing_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<SlicingParams>(
      app, "slicing", "Time the maps of technique caustics over numbers of planes, receiver by receiver",
      action, run_slicing, command);
  SlicingStudyOptions& options = params->options;
  command->add_option("scene", params->scenes, "Scene files with water")->required();
  command
      ->add_option("--planes", params->planes,
                   "By how many a receiver's box is cut, and ranges, as in 3..101")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  const std::vector<std::string> names = caustics_method_names();
  command->add_option("--methods", options.methods, "Only these; default: all")
      ->check(one_of(names))
      ->expected(1, int(names.size()));
  command->add_option("--rounds", options.rounds, "Measured maps of each method")
      ->check(number_between(1, 1000))
      ->capture_default_str();
  command->add_option("--map-size", options.map_size, "Texels along an edge of a receiver's maps")
      ->check(number_between(16, 4096))
      ->capture_default_str();
  command
      ->add_option("--layers", options.layers,
                   "Of the position map: with 2, edges stop light that is bent aside")
      ->check(number_between(1, 2))
      ->capture_default_str();
  command->add_option("--without", options.without, "Names of receivers to leave out")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--gl", params->gl, "OpenGL back end")
      ->check(one_of({"osmesa", "egl"}))
      ->capture_default_str();
  command->add_option("-o,--output", params->output, "Folder to write")->required();
  command->footer(
      R"(Writes slicing.md and index.html: of each receiver, under each light, what each method takes by the number of planes,
how many of them the receiver lies on, and whether all ways of cutting give the same bits; with charts of the times, and of
how many texels lie at which depth. The methods take turns, alone on the machine, after one map each to warm up.

Examples:
  lightbench slicing pool.json -o slicing
  lightbench slicing teapot.json sphere.json --planes 3..101 --without floor -o slicing)");
}

}  // namespace lightbench
