#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "base/descriptors.h"
#include "base/error.h"
#include "base/orphans.h"
#include "base/stopwatch.h"
#include "base/utf8.h"
#include "pipeline/bake_folder.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_range.h"
#include "pipeline/commands/view_options.h"
#include "pipeline/console.h"
#include "pipeline/tables.h"
#include "renderer/radiance/object_bake.h"
#include "renderer/radiance/radiance_file.h"
#include "renderer/techniques/surface_radiance.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

struct BakeParams {
  std::string scene;
  std::string out = "baked";
  std::vector<std::string> params;
  int threads = 0;
};

/// Whether anything is there but what a bake left that was killed before it had written its first file.
bool holds_files(const std::filesystem::path& folder) {
  const std::filesystem::directory_iterator entries(folder);
  return std::any_of(begin(entries), end(entries), [](const std::filesystem::directory_entry& entry) {
    return !is_temporary_name(entry.path().filename().string());
  });
}

/// A folder that no other bake works in, with what an interrupted bake of the same left; anything else must
/// not be mixed with it.
FolderLock prepare_folder(const std::filesystem::path& folder, const BakeFolder& bake) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error("cannot make the folder: " + error.message(), folder.string());
  FolderLock lock(folder / ".");  // the folder may be a link, as its user chose it
  if (lock.state() == Locked::by_another)
    throw Error("another bake is working in this folder", folder.string());
  if (lock.state() == Locked::yes) remove_orphans_in(folder);
  if (std::filesystem::exists(folder / "bake.json")) {
    if (read_bake_folder(folder).key != bake.key)
      throw Error(
          "holds objects that were baked from another scene or with other parameters: choose another "
          "folder, or remove it first",
          folder.string());
  } else if (holds_files(folder)) {
    throw Error("is not empty, and not a folder that 'lightbench bake' made", folder.string());
  }
  write_bake_folder(folder, bake);
  return lock;
}

/// A line that is written anew, on a terminal only.
class ProgressLine {
 public:
  explicit ProgressLine(const std::string& name)
      : name_(shortened(plain_line(name), 60)), shown_(isatty(STDERR_FILENO) == 1) {}
  ~ProgressLine() {
    if (shown_) std::fprintf(stderr, "\r\x1b[K");
  }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void operator()(double share) {
    const int percent = int(100 * share);
    if (shown_ && percent != last_) std::fprintf(stderr, "\r\x1b[K%s %d %%", name_.c_str(), last_ = percent);
  }

 private:
  std::string name_;
  bool shown_;
  int last_ = -1;
};

std::string tell(const ObjectBake& baked, double seconds) {
  const HalfStack& stack = baked.stack;
  double rays = 0;
  for (const RayRate& rate : baked.news.rays) rays += double(rate.rays);
  std::string text = fmt::format(
      "{} x {} texels of {} directions, {} on the surface, {:.1f} s: {:.0f} texels/s, {:.2f} million "
      "radiance "
      "samples/s, {:.2f} million rays/s",
      stack.width, stack.height, stack.grid.layers(), baked.texels, seconds, double(baked.texels) / seconds,
      double(baked.texels) * stack.grid.layers() / seconds / 1e6, rays / seconds / 1e6);
  if (baked.news.noise > 0) text += fmt::format(", noise {:.2f} of 255", baked.news.noise);
  return text;
}

ExitCode run_bake(const BakeParams& params) {
  const Technique technique = surface_radiance_technique();
  const ParamValues values = resolve_params(technique.params, technique.presets, "",
                                            parse_params(technique.params, params.params), "");
  BakeSettings settings = bake_settings(values);
  settings.trace.threads =
      params.threads > 0 ? params.threads : int(std::max(1u, std::thread::hardware_concurrency()));
  const Scene scene = load_scene(params.scene);
  print_warnings(scene.warnings);
  for (const auto& reason : reasons_against(technique, scene, values)) throw Error(reason, params.scene);
  check_named_sizes(scene, settings);
  const std::filesystem::path folder = params.out;
  const FolderLock lock = prepare_folder(folder, bake_folder(scene, values));
  const ObjectBaker baker(scene);
  for (const std::size_t entity : objects_to_bake(scene)) {
    const std::string name = object_file_stem(scene, entity);
    const std::filesystem::path file = folder / (name + ".mtex");
    if (std::filesystem::exists(file)) {
      say(name + ": there already");
      continue;
    }
    const Stopwatch watch;
    ObjectBake baked;
    {
      ProgressLine line(name);
      baked = baker.bake(entity, settings, [&](double share) { line(share); });
    }
    write_radiance(file, baked.stack);
    say(name + ": " + tell(baked, watch.seconds()));
    std::fflush(stdout);
  }
  say(folder.string());
  return ExitCode::ok;
}

}  // namespace

void add_bake_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<BakeParams>(
      app, "bake", "Trace what leaves a scene's surfaces, for technique surface_radiance", action, run_bake,
      command);
  command->add_option("scene", params->scene, "Scene file (.json) or OBJ")->required();
  command->add_option("-o,--out", params->out, "Folder for the objects' files")->capture_default_str();
  command
      ->add_option(
          "-p,--param", params->params,
          "NAME=VALUE of technique surface_radiance (lightbench list params); may stand several times")
      ->allow_extra_args(false);
  command->add_option("--threads", params->threads, "Threads; 0: one for each core")
      ->check(number_between(0, 256))
      ->capture_default_str();
  command->footer(
      R"(One file for each object, docs/formats.md; an interrupted bake goes on where it was. In a job, variants of
technique surface_radiance are baked by themselves.

Examples:
  lightbench bake room.json -o baked
  lightbench bake room.json -o baked -p texels=1e6 -p bounces=2 -p 'sizes=floor=512x512, box_*=256x256'
  lightbench render room.json --cameras room-cameras.json -t surface_radiance --baked baked -o room.png)");
}

}  // namespace lightbench
