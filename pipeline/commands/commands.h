#pragma once

#include <functional>
#include <memory>

#include <CLI/App.hpp>

#include "base/exit_code.h"

/// Each command is a struct of parameters, its options, and a function that runs it. Included by .cpp files
/// only.
namespace lightbench {

/// What the command line asked for; set while it is parsed.
using Action = std::function<ExitCode()>;

/// Makes a subcommand whose parameters live as long as the action.
template <typename Params>
std::shared_ptr<Params> add_command(CLI::App& parent, const char* name, const char* doc, Action& action,
                                    ExitCode (*run)(const Params&), CLI::App*& command) {
  auto params = std::make_shared<Params>();
  command = parent.add_subcommand(name, doc);
  command->callback([params, run, &action] { action = [params, run] { return run(*params); }; });
  return params;
}

void add_run_command(CLI::App& app, Action& action);
void add_oracle_command(CLI::App& app, Action& action);
void add_plan_command(CLI::App& app, Action& action);
void add_score_command(CLI::App& app, Action& action);
void add_report_command(CLI::App& app, Action& action);
void add_bench_command(CLI::App& app, Action& action);
void add_bake_command(CLI::App& app, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_export_command(CLI::App& app, Action& action);
void add_reference_command(CLI::App& app, Action& action);
void add_caustics_command(CLI::App& app, Action& action);
void add_slicing_command(CLI::App& app, Action& action);
void add_compare_command(CLI::App& app, Action& action);
void add_cameras_command(CLI::App& app, Action& action);
void add_scene_command(CLI::App& app, Action& action);
void add_list_command(CLI::App& app, Action& action);
void add_schema_command(CLI::App& app, Action& action);
void add_inspect_command(CLI::App& app, Action& action);
void add_work_command(CLI::App& app, Action& action);

}  // namespace lightbench
