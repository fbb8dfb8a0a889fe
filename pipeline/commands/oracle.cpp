#include <CLI/CLI.hpp>

#include "base/file_clashes.h"
#include "base/files.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/run_options.h"
#include "pipeline/console.h"
#include "pipeline/job_file.h"
#include "pipeline/kept_files.h"
#include "pipeline/oracle_job.h"
#include "pipeline/own_folder.h"

namespace lightbench {
namespace {

struct OracleParams {
  std::string job;
  std::vector<std::string> variants;
  RunFlags flags;
};

/// The oracle's job may stand where the job that was given does, which must not be lost.
void check_inputs_are_kept(const Job& job, const std::filesystem::path& out) {
  std::vector<NamedFile> outputs = run_files(out);
  for (const char* name : {"oracle.json", "oracle.md"})
    outputs.push_back({std::string("the run's ") + name, out / name});
  check_outputs(outputs, job_files(job));
}

ExitCode run_oracle(const OracleParams& params) {
  OracleJob oracle = oracle_job(read_job(params.job), params.variants);
  const RunOptions options = run_options(params.flags);
  const std::filesystem::path out = run_folder(oracle.job, options.out);
  check_inputs_are_kept(oracle.job, out);
  check_own_folder(out);
  oracle.job.file = out / "oracle.json";  // so that the folder can be scored and run again as it is
  write_file_atomic(oracle.job.file, job_text(oracle.job));
  const ExitCode code = run_job(oracle.job, options);
  const auto run = out / "run.json";
  const OracleTable table = oracle_table(run_report_from_json(read_file(run), run.string()), oracle.pairs);
  write_file_atomic(out / "oracle.md", oracle_markdown(table));
  say("\n" + oracle_text(table) + "\n" + (out / "oracle.md").string());
  return code;
}

}  // namespace

void add_oracle_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params =
      add_command<OracleParams>(app, "oracle", "Tell where screen-space variants of a job lose their gain",
                                action, run_oracle, command);
  command->add_option("job", params->job, "Job file (jobs/FORMAT.md)")->required();
  command
      ->add_option("--variant", params->variants,
                   "Only this variant, the baseline and the ceiling (repeatable); default: all")
      ->type_name("NAME")
      ->allow_extra_args(false);
  add_run_flags(*command, params->flags);
  command->footer(
      R"(Each variant of technique `isr` gets an oracle beside it: the same light, from the same pictures (guard band,
layers, cameras, bounces), gathered by exact rays instead of a search. With the ceiling, a path-traced image, the table
then says what is lost by searching, which a better search could win, and what is lost since no picture holds the
surface, which none could.

It is a run of its own in out/<job name>-oracle: it goes on where it was interrupted, and oracle.md keeps the table.
Gates of the job are left out. A run of the job itself can be copied there first, so that its pictures count.

Exit codes: 0 done; 2 a task failed, or INT or TERM ended the run; 3 bad input.

Examples:
  lightbench oracle jobs/isr.json
  lightbench oracle jobs/isr.json --variant fast --variant 'best, 1 layer'
  lightbench oracle jobs/isr.json --only 'cornell/*')");
}

}  // namespace lightbench
