#pragma once

#include <filesystem>

#include "base/process.h"
#include "pipeline/executor.h"

namespace lightbench {

/// Workers as child processes of this one, one thread each: `lightbench work PLAN`, which reads the ids of
/// its tasks from standard input, since a command line has room for some thousands only.
class LocalRunner : public Runner {
 public:
  /// `scratch` is a folder where workers keep temporary files.
  LocalRunner(std::filesystem::path program, std::filesystem::path plan_file, std::filesystem::path scratch);

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

}  // namespace lightbench
