#include <CLI/CLI.hpp>

#include "base/text.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/run_options.h"
#include "pipeline/commands/usage_errors.h"
#include "pipeline/job_file.h"

namespace lightbench {
namespace {

struct RunParams {
  std::string job;
  RunFlags flags;
  std::vector<std::string> stages;
  bool retry_failed = false;
  bool partial = false;
};

ExitCode run_run(const RunParams& params) {
  RunOptions options = run_options(params.flags);
  for (const auto& stage : params.stages) options.stages.insert(parse_stage(stage));
  options.retry_failed = params.retry_failed;
  options.partial = params.partial;
  return run_job(read_job(params.job), options);
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params =
      add_command<RunParams>(app, "run", "Do everything that a job file says", action, run_run, command);
  command->add_option("job", params->job, "Job file (jobs/FORMAT.md)")->required();
  add_run_flags(*command, params->flags);
  command->add_option("--stages", params->stages, "Only these: bake, snapshot, reference, score")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of({"bake", "snapshot", "reference", "score"}));
  command->add_flag("--retry-failed", params->retry_failed,
                    "Only what failed the last time, and what was skipped because of it");
  add_partial_flag(*command, params->partial);
  command->footer(
      R"(What is already there and still valid is not done again, so a run that was interrupted or failed
goes on with the same command. Every task runs in a process of its own; one that crashes is one failed row.

Exit codes: 0 all gates met; 1 a gate was not met; 2 a task failed, or INT or TERM ended the run; 3 bad input;
            5 a gate was not judged, since the run lacks all or some of its scores.

Examples:
  lightbench run jobs/cornell.json
  lightbench run jobs/rooms.json --only 'office/*' --partial
  lightbench run jobs/rooms.json --only 'office/*' --stages snapshot
  lightbench run jobs/rooms.json --out /data/rooms --jobs 8
  lightbench run jobs/rooms.json --retry-failed)");
}

}  // namespace lightbench
