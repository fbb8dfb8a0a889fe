#include "pipeline/time_left.h"

#include <algorithm>

namespace lightbench {
namespace {

/// That a worker takes to start and to load a scene, before it is known. Only the first tasks' estimate uses
/// it.
constexpr double kStartSeconds = 0.3;
/// So many measured tasks weigh as much as the first guess.
constexpr double kGuessWeight = 4;

}  // namespace

TimeLeft::TimeLeft(const Schedule& schedule) {
  const std::size_t tasks = schedule.count(TaskState::waiting);
  if (tasks > 0) first_guess_ = kStartSeconds * double(schedule.waiting_groups()) / double(tasks);
}

void TimeLeft::task_ended(TaskKind kind, double expected, double measured) {
  ++ended_;
  own_seconds_ += measured;
  if (measured <= 0) return;
  paces_[kind].expected += expected;
  paces_[kind].measured += measured;
}

double TimeLeft::pace(TaskKind kind) const {
  const auto found = paces_.find(kind);
  if (found == paces_.end() || found->second.expected <= 0) return 1.0;
  return std::clamp(found->second.measured / found->second.expected, 0.1, 10.0);
}

double TimeLeft::overhead_of_a_task(const Spent& spent) const {
  const double other = std::max(spent.workers - own_seconds_ - spent.unended, 0.0);
  return (kGuessWeight * first_guess_ + other) / (kGuessWeight + double(ended_));
}

double TimeLeft::seconds(const Schedule& schedule, int places, const Spent& spent) const {
  double own = 0;
  for (const TaskKind kind : {TaskKind::bake, TaskKind::compress, TaskKind::snapshot, TaskKind::export_,
                              TaskKind::reference, TaskKind::score})
    own += pace(kind) * schedule.remaining_seconds(kind);
  const double open = double(schedule.count(TaskState::waiting) + schedule.count(TaskState::running));
  return (std::max(own - spent.expected, 0.0) + open * overhead_of_a_task(spent)) / double(places);
}

}  // namespace lightbench
