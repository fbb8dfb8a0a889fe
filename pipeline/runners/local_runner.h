#pragma once

#include <filesystem>

#include "base/process.h"
#include "pipeline/executor.h"

namespace lightbench {

/// Workers as child processes of this one: `lightbench work PLAN TASK...`, one thread each.
class LocalRunner : public Runner {
 public:
  /// `scratch` is where workers keep temporary files. What a killed run left in it is removed now, and all of
  /// it at the end. Throws Error when it cannot be made.
  LocalRunner(std::filesystem::path program, std::filesystem::path plan_file, std::filesystem::path scratch);
  LocalRunner(const LocalRunner&) = delete;
  LocalRunner& operator=(const LocalRunner&) = delete;
  ~LocalRunner() override;

  void start(const std::vector<const Task*>& tasks, LineHandler on_line, EndHandler on_end) override;
  void every(std::chrono::milliseconds interval, std::function<void()> tick) override;
  void run() override { loop_.run(); }
  bool interrupted() const override { return loop_.interrupted(); }

 private:
  std::filesystem::path program_;
  std::filesystem::path plan_file_;
  std::filesystem::path scratch_;
  ProcessLoop loop_;
};

/// The last lines of a text, in one line.
std::string last_lines(const std::string& text, std::size_t count);

}  // namespace lightbench
