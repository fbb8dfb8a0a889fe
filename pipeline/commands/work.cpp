#include "pipeline/work.h"

#include <cstdio>
#include <iostream>

#include <CLI/CLI.hpp>

#include "pipeline/commands/commands.h"

namespace lightbench {
namespace {

struct WorkParams {
  std::string plan;
  std::vector<std::string> tasks;
};

/// One id a line.
std::vector<std::string> ids_from_input() {
  std::vector<std::string> ids;
  for (std::string line; std::getline(std::cin, line);)
    if (!line.empty()) ids.push_back(line);
  return ids;
}

ExitCode run_work(const WorkParams& params) {
  const auto ids = params.tasks.empty() ? ids_from_input() : params.tasks;
  work_tasks(params.plan, ids, [](const std::string& line) {
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
  command->add_option("tasks", params->tasks, "Ids of tasks; without any, they are read from standard input");
}

}  // namespace lightbench
