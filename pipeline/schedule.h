#pragma once

#include <string>
#include <vector>

#include "pipeline/plan.h"

namespace lightbench {

enum class TaskState {
  waiting,  ///< for its dependencies, or for a free place
  running,  ///< handed out to a worker
  done,     ///< by this run
  cached,   ///< by an earlier run, and still valid
  failed,   ///< itself
  skipped,  ///< not wanted, or something that it needs is not there
};

/// Which task comes next: the one with the longest way to the end of the run, together with others that share
/// what a worker loads for it. Pure bookkeeping; it starts nothing.
class Schedule {
 public:
  /// `seconds` is what each task is expected to take.
  Schedule(const std::vector<Task>& tasks, std::vector<double> seconds);

  /// Before the start: what need not be done.
  void set_cached(std::size_t task);
  /// Ends a task that was not started; everything that needs it is skipped too.
  void skip(std::size_t task, const std::string& reason);

  /// The tasks for one worker, in order, or none: nothing is ready, or memory (in MB) does not suffice while
  /// others run. They count as running. Large groups are cut so that `places` workers have something to do.
  std::vector<std::size_t> next_batch(int places, int free_memory_mb, bool others_run);

  void done(std::size_t task);
  void fail(std::size_t task, const std::string& error);
  /// A task that was handed out but not begun waits again.
  void give_back(std::size_t task);

  TaskState state(std::size_t task) const { return states_[task]; }
  const std::string& reason(std::size_t task) const { return reasons_[task]; }
  std::size_t count(TaskState state) const;
  /// The groups that waiting tasks belong to; one without a group counts as its own. Each needs a worker.
  std::size_t waiting_groups() const;
  /// Of the tasks that are waiting or running.
  double remaining_seconds(TaskKind kind) const;
  double seconds(std::size_t task) const { return seconds_[task]; }
  double seconds(const Task& task) const { return seconds_[std::size_t(&task - tasks_.data())]; }

 private:
  bool ready(std::size_t task) const;
  double batch_seconds(const std::string& group, int places) const;
  void skip_dependents(std::size_t task, const std::string& reason);

  const std::vector<Task>& tasks_;
  std::vector<double> seconds_;
  std::vector<double> way_;  ///< seconds from a task's start to the end of the longest chain that needs it
  std::vector<TaskState> states_;
  std::vector<std::string> reasons_;
  std::vector<std::vector<std::size_t>> dependents_;
};

}  // namespace lightbench
