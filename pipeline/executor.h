#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/cache.h"
#include "pipeline/plan.h"
#include "pipeline/schedule.h"

namespace lightbench {

/// How a worker ended.
struct WorkerEnd {
  bool ok = false;
  std::string how;         ///< "exit code 1", "killed by signal 9"
  std::string last_words;  ///< the end of its error stream
};

/// Starts workers; tests replace it by a fake.
class Runner {
 public:
  using LineHandler = std::function<void(std::string_view line)>;
  using EndHandler = std::function<void(const WorkerEnd& end)>;

  virtual ~Runner() = default;
  /// A worker that does the tasks in order and tells each step on a line: `start ID`, then `done ID JSON` or
  /// `fail ID JSON`. Handlers are called from `run` only, and may start further workers.
  virtual void start(const std::vector<const Task*>& tasks, LineHandler on_line, EndHandler on_end) = 0;
  virtual void every(std::chrono::milliseconds interval, std::function<void()> tick) = 0;
  /// Returns when no worker is left.
  virtual void run() = 0;
  /// A signal asked for the end: nothing more is to be started.
  virtual bool interrupted() const = 0;
};

/// How a task ended; every task of a plan has exactly one.
struct TaskOutcome {
  TaskState state = TaskState::waiting;
  std::string reason;  ///< of failed and skipped
  double expected_seconds = 0;
  std::optional<LedgerEntry> entry;  ///< of done and cached
};

/// Sees how a run goes on.
class Watcher {
 public:
  virtual ~Watcher() = default;
  virtual void begin(const Schedule& schedule) = 0;
  /// So many workers live now.
  virtual void workers(std::size_t count) = 0;
  virtual void started(const Task& task) = 0;
  virtual void ended(const Task& task, const TaskOutcome& outcome) = 0;
  virtual void tick() = 0;
  virtual void finish() = 0;
};

struct ExecuteOptions {
  int places = 1;              ///< workers at a time
  int memory_mb = 1 << 20;     ///< that all of them together may use, as far as it is known
  std::vector<bool> selected;  ///< one for each task; empty: all
};

/// Does what the plan says and is not there yet. A task that fails or whose worker dies is recorded and the
/// rest goes on. Throws Error only where the run itself cannot go on (the ledger cannot be written).
std::vector<TaskOutcome> execute(const Plan& plan, Cache& cache, Runner& runner, Watcher& watcher,
                                 const ExecuteOptions& options);

}  // namespace lightbench
