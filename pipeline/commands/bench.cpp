#include "pipeline/bench.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/file_clashes.h"
#include "base/files.h"
#include "base/text.h"
#include "pipeline/commands/busy.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/number_range.h"
#include "pipeline/commands/run_options.h"
#include "pipeline/commands/usage_errors.h"
#include "pipeline/concrete.h"
#include "pipeline/console.h"
#include "pipeline/inspect.h"
#include "pipeline/job_file.h"
#include "pipeline/kept_files.h"
#include "pipeline/run_job.h"
#include "pipeline/snapshot.h"
#include "renderer/renderer.h"
#include "renderer/technique.h"
#include "scene/scene_file.h"

namespace lightbench {
namespace {

struct BenchParams {
  std::string job;
  int rounds = 10;
  std::string only;
  std::string gl = "osmesa";
  std::string out;
  std::string output;
};

bool needs_bake(const JobVariant& variant) {
  return find_technique(variant.technique, "").needs_bake;
}

/// Throws Error where the output would replace what is measured, before the minutes of measuring begin.
void check_output(const std::filesystem::path& file, const Job& job) {
  std::vector<NamedFile> inputs = job_files(job);
  if (std::filesystem::exists(file))  // or there is nothing to replace, and no need to read the scenes for it
    for (const JobScene& scene : job.scenes)
      for (auto& input : named("a file of scene '" + scene.name + "'", file_paths(load_scene(scene.file))))
        inputs.push_back(std::move(input));
  check_outputs(std::array{NamedFile{"-o", file}}, inputs);
  require_writable(file);
}

void tell_left_out(const Job& job) {
  std::vector<std::string> names;
  for (const JobVariant& variant : job.variants)
    if (!is_timed(variant)) names.push_back(variant.name);
  if (!names.empty())
    say_aside("not timed, since they are path-traced or other engines' pictures: " + join(names, ", "));
}

ExitCode run_bench(const BenchParams& params) {
  const Job job = read_job(params.job);
  const std::filesystem::path out = run_folder(job, params.out);
  const std::filesystem::path file =
      params.output.empty() ? out / "bench.json" : std::filesystem::path(params.output);
  check_output(file, job);
  if (std::any_of(job.variants.begin(), job.variants.end(), needs_bake)) {
    RunOptions baking;
    baking.out = out, baking.only = params.only, baking.gl = params.gl;
    bake_job(job, baking);
  }
  const TemporaryFolder drawn;
  const Job concrete = make_concrete(job, drawn.path(), draw_job_views);
  warn_if_busy();
  const auto rows = bench_job(concrete, out, params.gl, params.rounds, params.only);
  if (rows.empty())
    throw Error(
        "no scene/view/variant is there to time; path-traced variants and pictures of other engines have no "
        "times",
        params.only);
  tell_left_out(job);
  say(bench_table(rows) + "\n" + bench_means(rows));
  const std::string renderer = Renderer(parse_gl(params.gl, "--gl")).description();
  write_file_atomic(file, bench_json(concrete, rows, params.rounds, renderer));
  say(renderer + "\n" + file.string());
  return ExitCode::ok;
}

}  // namespace

void add_bench_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params =
      add_command<BenchParams>(app, "bench", "Time a job's variants, per pass", action, run_bench, command);
  command->add_option("job", params->job, "Job file (jobs/FORMAT.md)")->required();
  command->add_option("--rounds", params->rounds, "Measured frames of each view and variant")
      ->check(number_between(1, 10000))
      ->capture_default_str();
  command->add_option("--only", params->only, "Only what matches this pattern of scene/view/variant");
  command->add_option("--gl", params->gl, "OpenGL back end")
      ->check(one_of({"osmesa", "egl"}))
      ->capture_default_str();
  command->add_option("--out", params->out, "Folder of the run, for what is baked; default: out/<job name>")
      ->check(not_empty());
  command->add_option("-o,--output", params->output,
                      "JSON file to write; default: bench.json in the run's folder");
  command->footer(
      R"(Times that an ordinary run meets are marked contended, since other tasks run beside. Here variants take
turns, alone on the machine, after two frames each to warm up; nothing comes from a cache but baked objects, which
are made first where they are missing. Path-traced variants and
pictures of other engines are left out.

Examples:
  lightbench bench jobs/cornell.json --rounds 20
  lightbench bench jobs/isr.json --only 'cornell/corner/fast*')");
}

}  // namespace lightbench
