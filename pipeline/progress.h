#pragma once

#include <cstdio>
#include <map>
#include <string>

#include "base/stopwatch.h"
#include "pipeline/executor.h"
#include "pipeline/time_left.h"

namespace lightbench {

/// How a run goes on: one line that is written over and over on a terminal, plain lines elsewhere.
class Progress : public Watcher {
 public:
  enum class Style { terminal, lines };

  Progress(std::FILE* stream, Style style, int places) : stream_(stream), style_(style), places_(places) {}
  /// By what the stream is.
  static Style style_of(std::FILE* stream);

  void begin(const Schedule& schedule) override;
  void workers(std::size_t count) override;
  void started(const Task& task) override;
  void ended(const Task& task, const TaskOutcome& outcome) override;
  void tick() override;
  void finish() override;

 private:
  std::string status() const;
  double worker_seconds() const;
  double remaining_seconds() const;
  void line(const std::string& text);
  void tell_repeated();

  std::FILE* stream_;
  Style style_;
  int places_;
  const Schedule* schedule_ = nullptr;
  Stopwatch watch_;
  TimeLeft time_left_;
  std::size_t workers_ = 0;
  Stopwatch since_;            ///< the number of workers changed
  double worker_seconds_ = 0;  ///< that all workers lived until then
  std::map<const Task*, Stopwatch> running_;
  std::string latest_;
  std::string last_failure_;
  std::size_t repeated_ = 0;  ///< failures after it with the same message
};

}  // namespace lightbench
