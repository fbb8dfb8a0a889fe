#include "pipeline/run_job.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file_clashes.h"
#include "base/files.h"
#include "base/stopwatch.h"
#include "pipeline/concrete.h"
#include "pipeline/console.h"
#include "pipeline/executor.h"
#include "pipeline/gather.h"
#include "pipeline/inspect.h"
#include "pipeline/kept_files.h"
#include "pipeline/own_folder.h"
#include "pipeline/plan_file.h"
#include "pipeline/progress.h"
#include "pipeline/run_folder.h"
#include "pipeline/runners/local_runner.h"
#include "pipeline/scene_children.h"
#include "pipeline/selection.h"
#include "reports/report_formats.h"

namespace lightbench {
namespace {

int memory_mb() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page_size = sysconf(_SC_PAGESIZE);
  return pages > 0 ? int(double(pages) * double(page_size) / (1 << 20) * 0.9) : 1 << 20;
}

/// A reference that is asked for and cannot be made stops the run before any work.
void check_tools(const PreparedRun& run, const std::vector<bool>& selected) {
  for (std::size_t i = 0; i < run.plan.tasks.size(); ++i) {
    const Task& task = run.plan.tasks[i];
    if (task.kind != TaskKind::reference || (!selected.empty() && !selected[i])) continue;
    const auto missing =
        run.facts.missing_tools.find(run.plan.job.references[std::size_t(task.reference)].kind);
    if (missing != run.facts.missing_tools.end()) throw Error(missing->second);
  }
}

bool any(const std::vector<bool>& selected) {
  return std::find(selected.begin(), selected.end(), true) != selected.end();
}

/// The tasks that the options ask for; empty: all.
std::vector<bool> selection(const Plan& plan, const Ledger& ledger, const RunOptions& options) {
  std::vector<bool> selected;
  if (!options.only.empty() || !options.stages.empty()) {
    selected = select_tasks(plan, options.stages, options.only);
    if (!any(selected)) throw Error("nothing in the job matches '" + options.only + "'", "--only");
  }
  if (!options.retry_failed) return selected;
  std::vector<bool> failed = select_failed(plan, ledger.last());
  for (std::size_t i = 0; i < selected.size(); ++i) failed[i] = failed[i] && selected[i];
  const char* of = selected.empty() ? "no task" : "no task that is asked for";
  if (!any(failed)) say(std::string(of) + " failed the last time: there is nothing to retry");
  return failed;
}

void print_end(const RunReport& report, const std::filesystem::path& out, bool interrupted) {
  say("\n" + terminal_summary(report));
  if (interrupted) say("interrupted: the same command goes on from here");
  say("\n" + (out / "index.html").string());
}

/// --retry-failed asks for a run that there is.
void check_retry(const Job& job, const RunOptions& options) {
  const auto ledger = run_folder(job, options.out) / "ledger.jsonl";
  std::error_code error;
  if (options.retry_failed && !std::filesystem::exists(ledger, error))
    throw Error("there is no run in this folder, so none of its tasks can be tried again: " +
                    ledger.parent_path().string(),
                "--retry-failed");
}

/// Returns the run's folder, after making sure that no file of the run would replace what the job names, nor
/// stand among files of others.
std::filesystem::path checked_folder(const Job& job, const RunOptions& options) {
  const auto out = run_folder(job, options.out);
  std::vector<NamedFile> outputs = run_files(out);
  for (const JobScene& scene : job.scenes)
    if (std::holds_alternative<RandomViewsRequest>(scene.views))
      outputs.push_back({"the views drawn of scene '" + scene.name + "'", out / stored_cameras(scene)});
  check_outputs(outputs, job_files(job));
  check_own_folder(out);
  return out;
}

/// A run under way, in its folder.
struct StartedRun {
  StartedRun(const Job& job, const RunOptions& options)
      : out(checked_folder(job, options)),
        ledger(out / "ledger.jsonl", LedgerUse::append),
        places(worker_places(options.places)),
        prepared(prepare_run(job, out, options.gl, places)) {
    check_outputs_of(prepared.plan, prepared.facts);
    std::signal(SIGPIPE, SIG_IGN);  // work and its exit code do not depend on who reads the progress
  }

  /// Returns how each task ended; empty `selected`: all are done.
  std::vector<TaskOutcome> execute_tasks(const std::vector<bool>& selected) {
    check_tools(prepared, selected);
    const auto plan_file = out / "plan.json";
    write_file_atomic(plan_file, plan_to_json(prepared.plan));
    FolderCache cache(ledger, out);
    const Workspace workspace(prepared.plan);
    LocalRunner runner(executable_path(), plan_file, workspace.scratch());
    Progress progress(stdout, Progress::style_of(stdout), places);
    auto outcomes = execute(prepared.plan, cache, runner, progress, {places, memory_mb(), selected});
    interrupted = runner.interrupted();
    return outcomes;
  }

  std::filesystem::path out;
  Ledger ledger;
  int places;
  PreparedRun prepared;
  bool interrupted = false;
};

}  // namespace

std::filesystem::path run_folder(const Job& job, const std::filesystem::path& out) {
  const std::filesystem::path folder =
      out.empty() ? std::filesystem::path("out") / escape_file_name(job.name) : out;
  return std::filesystem::absolute(folder).lexically_normal();
}

int worker_places(int asked) {
  return asked > 0 ? asked : int(std::max(1u, std::thread::hardware_concurrency()));
}

PreparedRun prepare_run(const Job& job, const std::filesystem::path& out, const std::string& gl, int places) {
  PreparedRun run;
  const SceneChildren children(executable_path(), places);
  const Job concrete =
      make_concrete(job, out, [&](const JobScene& scene, const RandomViewsRequest& request, double) {
        return children.draw_views(job, scene, request);
      });
  run.facts = inspect(concrete, gl, [&](const Job& whole) { return children.inspect(whole); });
  run.plan = make_plan(concrete, run.facts, out);
  return run;
}

void bake_job(const Job& job, const RunOptions& options) {
  StartedRun run(job, options);
  const std::vector<Task>& tasks = run.prepared.plan.tasks;
  std::vector<bool> selected =
      select_tasks(run.prepared.plan, {TaskKind::snapshot, TaskKind::bake, TaskKind::compress}, options.only);
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (tasks[i].kind == TaskKind::snapshot) selected[i] = false;
  if (!any(selected)) return;
  const auto outcomes = run.execute_tasks(selected);
  if (run.interrupted) throw Error("interrupted: the same command goes on from here");
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (selected[i] && outcomes[i].state == TaskState::failed)
      throw Error(outcomes[i].reason, tasks[i].label);
}

ExitCode run_job(const Job& job, const RunOptions& options) try {
  const Stopwatch watch;
  const std::string started = utc_now();
  check_retry(job, options);
  StartedRun run(job, options);
  const std::vector<bool> selected = selection(run.prepared.plan, run.ledger, options);
  const auto outcomes = run.execute_tasks(selected);
  RunReport report = gather_report(run.prepared.plan, run.prepared.facts, outcomes,
                                   options.partial ? GateScope::what_is_there : GateScope::all_scores);
  report.started = started;
  report.seconds = watch.seconds();
  write_reports(report, run.out);
  print_end(report, run.out, run.interrupted);
  return run.interrupted ? ExitCode::task_failed : exit_code_of(report, outcomes, selected);
} catch (const Interrupted& interrupted) {
  say(interrupted.what());
  return ExitCode::task_failed;
}

}  // namespace lightbench
