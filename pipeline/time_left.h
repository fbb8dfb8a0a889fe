#pragma once

#include <cstddef>
#include <map>

#include "pipeline/schedule.h"

namespace lightbench {

/// Seconds that a run has spent so far.
struct Spent {
  double workers = 0;   ///< that all its workers have lived, together
  double unended = 0;   ///< since the tasks that are running now began
  double expected = 0;  ///< of these, what does not go beyond what each is expected to take
};

/// Tells how much longer a run takes. A task's own seconds are scaled by how tasks of its kind have gone so
/// far. What they do not hold (a worker's start, its reading of the plan, loading a scene) is what else the
/// workers' time went into, shared out to the tasks.
class TimeLeft {
 public:
  TimeLeft() = default;
  /// At the begin of a run.
  explicit TimeLeft(const Schedule& schedule);

  /// A task has ended; `measured` are its own seconds, or 0 where it does not say.
  void task_ended(TaskKind kind, double expected, double measured);

  /// Returns how long a task of that kind takes, as a multiple of what is expected.
  double pace(TaskKind kind) const;
  /// Returns seconds, with `places` workers at a time.
  double seconds(const Schedule& schedule, int places, const Spent& spent) const;

 private:
  double overhead_of_a_task(const Spent& spent) const;

  struct Pace {
    double expected = 0;
    double measured = 0;
  };
  std::map<TaskKind, Pace> paces_;  ///< of the tasks that this run ended
  double first_guess_ = 0;          ///< of the overhead of a task
  std::size_t ended_ = 0;
  double own_seconds_ = 0;
};

}  // namespace lightbench
