#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/plan.h"
#include "pipeline/task_result.h"

namespace lightbench {

/// Does tasks of one plan, one after the other, and keeps the last scene, its exports and the OpenGL context.
class TaskWorker {
 public:
  explicit TaskWorker(const Plan& plan);
  TaskWorker(const TaskWorker&) = delete;
  TaskWorker& operator=(const TaskWorker&) = delete;
  ~TaskWorker();

  /// Throws Error when the task fails; its files are then whole or not there.
  TaskResult work(const Task& task);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Does the named tasks of a plan file and prints `start ID`, then `done ID JSON` or `fail ID JSON` for each.
/// Throws Error only where the plan cannot be read or a task is not in it.
void work_tasks(const std::string& plan_file, const std::vector<std::string>& ids,
                const std::function<void(const std::string& line)>& say);

}  // namespace lightbench
