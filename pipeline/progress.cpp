#include "pipeline/progress.h"

#include <algorithm>

#include <fmt/format.h>
#include <unistd.h>

#include "base/utf8.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

const char* state_text(TaskState state) {
  switch (state) {
    case TaskState::done:
      return "done";
    case TaskState::cached:
      return "there already";
    case TaskState::failed:
      return "FAILED";
    default:
      return "skipped";
  }
}

}  // namespace

Progress::Style Progress::style_of(std::FILE* stream) {
  return isatty(fileno(stream)) ? Style::terminal : Style::lines;
}

void Progress::begin(const Schedule& schedule) {
  schedule_ = &schedule;
  watch_ = Stopwatch();
  time_left_ = TimeLeft(schedule);
  const std::size_t cached = schedule.count(TaskState::cached);
  const std::size_t waiting = schedule.count(TaskState::waiting);
  line(fmt::format("{} to do, {} there already; expected {} on {}", counted(waiting, "task"), cached,
                   duration_text(remaining_seconds()), counted(std::size_t(places_), "worker")));
}

void Progress::workers(std::size_t count) {
  worker_seconds_ = worker_seconds();
  since_ = Stopwatch();
  workers_ = count;
}

void Progress::started(const Task& task) {
  latest_ = task.id;
  running_[&task] = Stopwatch();
  tick();
}

void Progress::ended(const Task& task, const TaskOutcome& outcome) {
  const bool failed = outcome.state == TaskState::failed;
  running_.erase(&task);
  time_left_.task_ended(task.kind, outcome.expected_seconds,
                        outcome.entry ? outcome.entry->result.seconds : 0.0);
  if (failed && outcome.reason == last_failure_) ++repeated_;
  if (failed && outcome.reason != last_failure_) {
    tell_repeated();
    line(fmt::format("{} FAILED: {}", task.id, outcome.reason));
    last_failure_ = outcome.reason;
  }
  if (!failed && style_ == Style::lines && schedule_)
    line(fmt::format("{} {} ({:.2f} s){}", task.id, state_text(outcome.state),
                     outcome.entry ? outcome.entry->result.seconds : 0.0, status()));
  tick();
}

/// A scene that cannot be read fails all its tasks with one message.
void Progress::tell_repeated() {
  if (repeated_ > 0) line(fmt::format("{} more FAILED with the same message", repeated_));
  repeated_ = 0;
}

void Progress::tick() {
  if (style_ != Style::terminal || !schedule_) return;
  std::fprintf(stream_, "\r\x1b[K%s  %s", status().c_str(), shortened(plain_line(latest_), 60).c_str());
  std::fflush(stream_);
}

void Progress::finish() {
  tell_repeated();
  if (style_ == Style::terminal) std::fprintf(stream_, "\r\x1b[K");
  const double seconds = watch_.seconds();
  if (schedule_)
    line(fmt::format("{} done, {} there already, {} failed, {} skipped in {}",
                     schedule_->count(TaskState::done), schedule_->count(TaskState::cached),
                     schedule_->count(TaskState::failed), schedule_->count(TaskState::skipped),
                     duration_text(seconds)));
  schedule_ = nullptr;
}

double Progress::worker_seconds() const {
  return worker_seconds_ + double(workers_) * since_.seconds();
}

double Progress::remaining_seconds() const {
  Spent spent{.workers = worker_seconds()};
  for (const auto& [task, watch] : running_) {
    const double expected = time_left_.pace(task->kind) * schedule_->seconds(*task);
    spent.unended += watch.seconds();
    spent.expected += std::min(watch.seconds(), expected);
  }
  return time_left_.seconds(*schedule_, places_, spent);
}

/// " [7/12, 1 failed, 8 s, about 20 s to go]"
std::string Progress::status() const {
  const std::size_t done = schedule_->count(TaskState::done);
  const std::size_t failed = schedule_->count(TaskState::failed);
  const std::size_t open = schedule_->count(TaskState::waiting) + schedule_->count(TaskState::running);
  const double seconds = watch_.seconds();
  const std::string failures = failed ? fmt::format(", {} failed", failed) : "";
  return fmt::format(" [{}/{}{}, {}, about {} to go]", done + failed, done + failed + open, failures,
                     duration_text(seconds), duration_text(remaining_seconds()));
}

void Progress::line(const std::string& text) {
  if (style_ == Style::terminal) std::fprintf(stream_, "\r\x1b[K");
  std::fprintf(stream_, "%s\n", clean_utf8(text).c_str());
  std::fflush(stream_);
}

}  // namespace lightbench
