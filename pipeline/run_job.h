#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "base/exit_code.h"
#include "pipeline/ledger.h"
#include "pipeline/plan.h"

namespace lightbench {

struct RunOptions {
  std::filesystem::path out;  ///< empty: out/<job name>
  int places = 0;             ///< workers at a time; 0: as many as there are cores
  std::string only;           ///< pattern of task labels; empty: all
  std::set<TaskKind> stages;  ///< empty: all
  bool retry_failed = false;  ///< only what failed the last time, and what was skipped because of it
  bool partial = false;       ///< gates are judged by the scores that are there
  std::string gl = "osmesa";
};

/// The run's folder: as given, else out/<job name>.
std::filesystem::path run_folder(const Job& job, const std::filesystem::path& out);

/// A job with everything that a run needs to know before it starts.
struct PreparedRun {
  PlanFacts facts;
  Plan plan;
};

/// Makes the job concrete (which may store drawn views in the run's folder), reads its scenes and plans.
PreparedRun prepare_run(const Job& job, const std::filesystem::path& out, const std::string& gl, int places);

/// Workers at a time: as many as are asked for, or where that is 0 as there are cores.
int worker_places(int asked);

/// Bakes into the run's folder what those snapshots draw that match `only`, and is not there yet. Throws
/// Error where one of the objects could not be baked, and when a signal ended it.
void bake_job(const Job& job, const RunOptions& options);

/// Does what a job asks for and is not there yet, writes the reports and prints a summary. INT and TERM end
/// it early and keep what is done. Throws Error for bad input, a missing reference tool, and a folder that
/// cannot be written.
ExitCode run_job(const Job& job, const RunOptions& options);

}  // namespace lightbench
