#include "pipeline/schedule.h"

#include <algorithm>
#include <cassert>
#include <set>
#include <string_view>

namespace lightbench {
namespace {

/// Loading a scene takes about a second, so a worker should have a few seconds of work; the upper bound keeps
/// a run's end from waiting for one worker.
constexpr double kMinBatchSeconds = 2;
constexpr double kMaxBatchSeconds = 20;

}  // namespace

Schedule::Schedule(const std::vector<Task>& tasks, std::vector<double> seconds)
    : tasks_(tasks),
      seconds_(std::move(seconds)),
      way_(seconds_),
      states_(tasks.size(), TaskState::waiting),
      reasons_(tasks.size()),
      dependents_(tasks.size()) {
  assert(seconds_.size() == tasks.size());
  for (std::size_t i = tasks.size(); i-- > 0;)
    for (const std::size_t dep : tasks[i].deps) {
      assert(dep < i);
      dependents_[dep].push_back(i);
      way_[dep] = std::max(way_[dep], seconds_[dep] + way_[i]);
    }
}

void Schedule::set_cached(std::size_t task) {
  assert(states_[task] == TaskState::waiting);
  states_[task] = TaskState::cached;
}

void Schedule::skip(std::size_t task, const std::string& reason) {
  assert(states_[task] == TaskState::waiting);
  states_[task] = TaskState::skipped;
  reasons_[task] = reason;
  skip_dependents(task, "needs " + tasks_[task].id + ": " + reason);
}

void Schedule::skip_dependents(std::size_t task, const std::string& reason) {
  for (const std::size_t dependent : dependents_[task]) {
    if (states_[dependent] != TaskState::waiting) continue;
    states_[dependent] = TaskState::skipped;
    reasons_[dependent] = reason;
    skip_dependents(dependent, reason);
  }
}

void Schedule::done(std::size_t task) {
  assert(states_[task] == TaskState::running);
  states_[task] = TaskState::done;
}

void Schedule::fail(std::size_t task, const std::string& error) {
  assert(states_[task] == TaskState::running || states_[task] == TaskState::waiting);
  states_[task] = TaskState::failed;
  reasons_[task] = error;
  skip_dependents(task, "needs " + tasks_[task].id + ", which failed: " + error.substr(0, error.find('\n')));
}

void Schedule::give_back(std::size_t task) {
  assert(states_[task] == TaskState::running);
  states_[task] = TaskState::waiting;
}

bool Schedule::ready(std::size_t task) const {
  if (states_[task] != TaskState::waiting) return false;
  const auto& deps = tasks_[task].deps;
  return std::all_of(deps.begin(), deps.end(), [&](std::size_t dep) {
    return states_[dep] == TaskState::done || states_[dep] == TaskState::cached;
  });
}

double Schedule::batch_seconds(const std::string& group, int places) const {
  double total = 0;
  for (std::size_t i = 0; i < tasks_.size(); ++i)
    if (tasks_[i].group == group && ready(i)) total += seconds_[i];
  return std::clamp(total / std::max(places, 1), kMinBatchSeconds, kMaxBatchSeconds);
}

std::vector<std::size_t> Schedule::next_batch(int places, int free_memory_mb, bool others_run) {
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < tasks_.size(); ++i)
    if (ready(i)) candidates.push_back(i);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](std::size_t a, std::size_t b) { return way_[a] > way_[b]; });
  const auto fits = [&](std::size_t i) {
    return !others_run || tasks_[i].resources.memory_mb <= free_memory_mb;
  };
  const auto first = std::find_if(candidates.begin(), candidates.end(), fits);
  if (first == candidates.end()) return {};

  std::vector<std::size_t> batch = {*first};
  const std::string& group = tasks_[*first].group;
  if (!group.empty()) {
    const double limit = batch_seconds(group, places);
    double total = seconds_[*first];
    for (auto next = first + 1; next != candidates.end() && total < limit; ++next) {
      if (tasks_[*next].group != group || !fits(*next)) continue;
      batch.push_back(*next);
      total += seconds_[*next];
    }
  }
  for (const std::size_t task : batch) states_[task] = TaskState::running;
  return batch;
}

std::size_t Schedule::count(TaskState state) const {
  return std::size_t(std::count(states_.begin(), states_.end(), state));
}

std::size_t Schedule::waiting_groups() const {
  std::set<std::string_view> groups;
  std::size_t alone = 0;
  for (std::size_t i = 0; i < tasks_.size(); ++i) {
    if (states_[i] != TaskState::waiting) continue;
    if (tasks_[i].group.empty())
      ++alone;
    else
      groups.insert(tasks_[i].group);
  }
  return alone + groups.size();
}

double Schedule::remaining_seconds(TaskKind kind) const {
  double total = 0;
  for (std::size_t i = 0; i < tasks_.size(); ++i)
    if (tasks_[i].kind == kind && (states_[i] == TaskState::waiting || states_[i] == TaskState::running))
      total += seconds_[i];
  return total;
}

}  // namespace lightbench
