#include <array>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file_clashes.h"
#include "base/files.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_range.h"
#include "pipeline/commands/view_options.h"
#include "pipeline/console.h"
#include "pipeline/inspect.h"
#include "reports/value_text.h"
#include "scene/camera_script.h"
#include "scene/motion.h"
#include "scene/random_views.h"
#include "scene/scene_file.h"
#include "scene/scene_json.h"

namespace lightbench {
namespace {

struct CamerasParams {
  std::string scene;
  int random = 1;
  std::uint64_t seed = 1;
  double fov = 60;
  int generator = kNewestGenerator;
  double time = 0;
  std::string size = "1024x768";
  std::string output;
};

ExitCode run_cameras(const CamerasParams& params) {
  const ImageSize size = parse_size(params.size);
  Scene scene = load_scene(params.scene);
  set_time(scene, params.time);
  check_outputs(std::array{NamedFile{"-o", params.output}}, named("a file of the scene", file_paths(scene)));
  const auto views = draw_views(scene, {params.random, params.seed, params.fov, params.generator},
                                double(size.width) / size.height);
  const std::string text = camera_script_text(views, DrawnBy{params.seed, params.generator});
  if (params.output.empty()) {
    std::printf("%s", text.c_str());
  } else {
    write_file_atomic(params.output, text);
    say(fmt::format("{}: {}", params.output, counted(views.size(), "view")));
  }
  return ExitCode::ok;
}

}  // namespace

void add_cameras_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<CamerasParams>(app, "cameras", "Draw valid random views of a scene", action,
                                           run_cameras, command);
  command->add_option("scene", params->scene, "Scene file (.json) or OBJ")->required();
  command->add_option("--random", params->random, "How many views")
      ->check(number_between(1, 10000))
      ->capture_default_str();
  command->add_option("--seed", params->seed, "The same seed gives the same views")
      ->check(number_between(0, 9007199254740992.0))  // as in a job
      ->capture_default_str();
  command->add_option("--fov", params->fov, "Vertical field of view, degrees")
      ->check(number_between(1.0, 170.0))
      ->capture_default_str();
  command->add_option("--generator", params->generator, "Version of what draws them, as 'version' in a job")
      ->check(number_between(1, kNewestGenerator))
      ->capture_default_str();
  command->add_option("--time", params->time, "Seconds: where entities with keyframes stand")
      ->check(number_between(-kLargestTime, kLargestTime))
      ->capture_default_str();
  command->add_option("--size", params->size, "Image size whose aspect ratio counts")->capture_default_str();
  command->add_option("-o,--output", params->output, "Camera script to write; default: standard output");
  command->footer(
      R"(A view is valid when it keeps clear of all surfaces, nothing near or flat fills it, it is not mostly
background, and light reaches what it shows. Views stand at the height of eyes where there is a floor, look at
a single object from around, and are spread over the scene. The same seed, generator and scene give the same
views; generator 1 draws those of before.

Example:
  lightbench cameras room.json --random 40 --seed 7 -o room-cameras.json)");
}

}  // namespace lightbench
