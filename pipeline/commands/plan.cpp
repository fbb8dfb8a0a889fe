#include <cstdio>
#include <filesystem>
#include <map>

#include <CLI/CLI.hpp>

#include "base/files.h"
#include "pipeline/cache.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/run_options.h"
#include "pipeline/console.h"
#include "pipeline/executor.h"
#include "pipeline/job_file.h"
#include "pipeline/plan_file.h"
#include "pipeline/selection.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

struct PlanParams {
  std::string job;
  RunFlags flags;
  bool explain = false;
  bool json = false;
};

void print_explanation(const Plan& plan, Cache& cache, const std::vector<bool>& selected) {
  std::size_t there = 0, to_do = 0;
  for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
    if (!selected[i]) continue;
    const Task& task = plan.tasks[i];
    const bool found = cache.find(task).has_value();
    ++(found ? there : to_do);
    const std::string why = !task.refused.empty() ? "cannot be done: " + task.refused
                            : found               ? "there already"
                                                  : "to do: " + cache.why_missing(task);
    say(task.id + "  " + why);
  }
  std::printf("%zu there already, %zu to do\n", there, to_do);
}

void print_counts(const Plan& plan, const std::vector<bool>& selected) {
  std::map<TaskKind, std::pair<std::size_t, double>> kinds;
  for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
    if (!selected[i]) continue;
    auto& [count, seconds] = kinds[plan.tasks[i].kind];
    ++count;
    seconds += plan.tasks[i].expected_seconds;
  }
  for (const auto& [kind, sum] : kinds)
    std::printf("%-10s %6zu tasks, about %s on one core\n", to_text(kind).c_str(), sum.first,
                duration_text(sum.second).c_str());
}

ExitCode run_plan(const PlanParams& params) {
  const Job job = read_job(params.job);
  const auto out = run_folder(job, params.flags.out);
  // Only a run may write to its folder; here views that a run would draw and keep are drawn aside.
  const TemporaryFolder aside;
  PreparedRun run = prepare_run(job, aside.path(), params.flags.gl, worker_places(params.flags.places));
  run.plan.out = out;
  const auto selected = select_tasks(run.plan, {}, params.flags.only);
  if (params.json) {
    std::printf("%s", plan_to_json(run.plan).c_str());
  } else if (params.explain) {
    Ledger ledger(out / "ledger.jsonl", LedgerUse::read);
    FolderCache cache(ledger, out);
    print_explanation(run.plan, cache, selected);
  } else {
    print_counts(run.plan, selected);
  }
  return ExitCode::ok;
}

}  // namespace

void add_plan_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params =
      add_command<PlanParams>(app, "plan", "Show what a run would do, and why", action, run_plan, command);
  command->add_option("job", params->job, "Job file (jobs/FORMAT.md)")->required();
  add_run_flags(*command, params->flags);
  command->add_flag("--explain", params->explain,
                    "Say of each task: there already, or which part of its key changed");
  command->add_flag("--json", params->json, "Print the plan as JSON");
  command->footer("Example:\n  lightbench plan jobs/cornell.json --explain");
}

}  // namespace lightbench
