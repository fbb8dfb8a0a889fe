#include <filesystem>

#include <CLI/CLI.hpp>

#include "pipeline/commands/commands.h"
#include "pipeline/commands/run_options.h"
#include "pipeline/job_file.h"
#include "pipeline/plan_file.h"

namespace lightbench {
namespace {

struct ScoreParams {
  std::string target;
  RunFlags flags;
  bool partial = false;
};

ExitCode run_score(const ScoreParams& params) {
  RunOptions options = run_options(params.flags);
  options.stages = {TaskKind::score};
  options.partial = params.partial;
  if (!std::filesystem::is_directory(params.target)) return run_job(read_job(params.target), options);
  const Plan plan = read_plan(std::filesystem::path(params.target) / "plan.json");
  if (options.out.empty()) options.out = params.target;
  options.gl = plan.gl;
  return run_job(read_job(plan.job.file), options);
}

}  // namespace

void add_score_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params = add_command<ScoreParams>(app, "score", "Score the pictures that a run has made", action,
                                         run_score, command);
  command->add_option("target", params->target, "Folder of a run, or its job file")->required();
  add_run_flags(*command, params->flags);
  add_partial_flag(*command, params->partial);
  command->footer(R"(The same as `lightbench run JOB --stages score`: nothing is rendered.

Example:
  lightbench score out/cornell)");
}

}  // namespace lightbench
