#pragma once

#include <cstdio>
#include <map>
#include <string>

#include "base/stopwatch.h"
#include "pipeline/executor.h"

namespace lightbench {

/// How a run goes on: one line that is written over and over on a terminal, plain lines elsewhere.
class Progress : public Watcher {
 public:
  enum class Style { terminal, lines };

  Progress(std::FILE* stream, Style style, int places) : stream_(stream), style_(style), places_(places) {}
  /// By what the stream is.
  static Style style_of(std::FILE* stream);

  void begin(const Schedule& schedule) override;
  void started(const Task& task) override;
  void ended(const Task& task, const TaskOutcome& outcome) override;
  void tick() override;
  void finish() override;

 private:
  struct Pace {
    double expected = 0;
    double measured = 0;
  };

  std::string status() const;
  double pace(TaskKind kind) const;
  double remaining_seconds() const;
  void line(const std::string& text);
  void tell_repeated();

  std::FILE* stream_;
  Style style_;
  int places_;
  const Schedule* schedule_ = nullptr;
  Stopwatch watch_;
  std::size_t cached_ = 0;
  std::map<TaskKind, Pace> paces_;  ///< of the tasks that this run ended
  std::map<const Task*, Stopwatch> running_;
  std::string latest_;
  std::string last_failure_;
  std::size_t repeated_ = 0;  ///< failures after it with the same message
};

}  // namespace lightbench
