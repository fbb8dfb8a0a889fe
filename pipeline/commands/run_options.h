#pragma once

#include <string>

#include <CLI/App.hpp>

#include "pipeline/run_job.h"

namespace lightbench {

/// Options of the commands that run a job or a part of it.
struct RunFlags {
  std::string out;
  int places = 0;
  std::string only;
  std::string gl = "osmesa";
};

void add_run_flags(CLI::App& command, RunFlags& flags);
void add_partial_flag(CLI::App& command, bool& partial);
/// Refuses an option's text that is empty, which would mean the default to what uses it.
CLI::Validator not_empty();
RunOptions run_options(const RunFlags& flags);
TaskKind parse_stage(const std::string& name);

}  // namespace lightbench
