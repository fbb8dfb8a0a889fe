#include "pipeline/work.h"

#include <cstdio>

#include <CLI/CLI.hpp>

#include "pipeline/commands/commands.h"

namespace lightbench {
namespace {

struct WorkParams {
  std::string plan;
  std::vector<std::string> tasks;
};

ExitCode run_work(const WorkParams& params) {
  work_tasks(params.plan, params.tasks, [](const std::string& line) {
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
  });
  return ExitCode::ok;
}

}  // namespace

void add_work_command(CLI::App& app, Action& action) {
  CLI::App* command = nullptr;
  auto params =
      add_command<WorkParams>(app, "work", "Do tasks of a plan (started by run)", action, run_work, command);
  command->group("");
  command->add_option("plan", params->plan, "Plan file")->required();
  command->add_option("tasks", params->tasks, "Ids of tasks")->required();
}

}  // namespace lightbench
