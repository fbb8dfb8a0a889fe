#include "pipeline/commands/run_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "pipeline/commands/number_range.h"
#include "pipeline/commands/usage_errors.h"

namespace lightbench {

CLI::Validator not_empty() {
  return {[](const std::string& text) { return text.empty() ? "must not be empty" : std::string(); }, ""};
}

void add_run_flags(CLI::App& command, RunFlags& flags) {
  command.add_option("--out", flags.out, "Folder of the run; default: out/<job name>")->check(not_empty());
  command.add_option("-j,--jobs", flags.places, "Workers at a time; default: one for each core")
      ->check(number_between(1, 1024));
  command.add_option(
      "--only", flags.only,
      "Only what matches this pattern of scene/view/variant or scene/view/reference, and what it needs");
  command.add_option("--gl", flags.gl, "OpenGL back end")
      ->check(one_of({"osmesa", "egl"}))
      ->capture_default_str();
}

void add_partial_flag(CLI::App& command, bool& partial) {
  command.add_flag("--partial", partial,
                   "Judge gates by the scores that this run has; without it a gate that lacks one of its "
                   "scores is not judged (exit code 5)");
}

RunOptions run_options(const RunFlags& flags) {
  RunOptions options;
  options.out = flags.out;
  options.places = flags.places;
  options.only = flags.only;
  options.gl = flags.gl;
  return options;
}

TaskKind parse_stage(const std::string& name) {
  const auto& names = task_kind_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw Error("there is no stage '" + name + "'", "--stages");
  return static_cast<TaskKind>(found - names.begin());
}

}  // namespace lightbench
