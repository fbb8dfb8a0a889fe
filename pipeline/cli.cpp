#include "pipeline/cli.h"

#include <cstdio>
#include <exception>
#include <sstream>

#include <CLI/CLI.hpp>
#include <poll.h>
#include <unistd.h>

#include "base/error.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/usage_errors.h"
#include "pipeline/console.h"
#include "pipeline/references.h"
#include "pipeline/version.h"

namespace lightbench {
namespace {

const char* const kFooter = R"(Examples:
  lightbench run jobs/cornell.json              do everything a job says; ends with the report's path
  lightbench render scene.obj -o picture.png    one picture of one scene
  lightbench compare a.png b.exr --diff d.png   how far two pictures are apart
  lightbench list                               techniques, metrics, references, formats and their parameters

Exit codes: 0 done, all gates met; 1 a gate was not met; 2 a task failed or was interrupted;
            3 bad usage, a bad file or a missing tool; 4 a bug; 5 a gate was not judged.
`lightbench COMMAND --help` says more about a command.)";

std::string version_text() {
  std::string text = "lightbench " + lightbench_version();
  for (const auto& [name, version] : tool_versions())
    if (name != "lightbench") text += "\n" + name + ": " + version;
  for (const auto& kind : reference_kinds()) {
    text += "\n" + kind.name + ": ";
    try {
      text += kind.tool_version();
    } catch (const Error& error) {
      text += error.what();
    }
  }
  return text;
}

void add_commands(CLI::App& app, Action& action) {
  for (const auto add :
       {add_run_command, add_oracle_command, add_plan_command, add_score_command, add_report_command,
        add_bench_command, add_bake_command, add_render_command, add_export_command, add_reference_command,
        add_compare_command, add_caustics_command, add_slicing_command, add_cameras_command,
        add_scene_command, add_list_command, add_schema_command, add_inspect_command, add_work_command})
    add(app, action);
}

ExitCode run_command(int argc, const char* const* argv) {
  CLI::App app("Measures how close real-time lighting techniques come to a path-traced truth.", "lightbench");
  app.footer(kFooter);
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text, "Versions of lightbench and of the tools that it runs");
  Action action;
  add_commands(app, action);
  check_commands(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const int code = app.exit(error, out, err);
    if (code != 0) check_leftovers(app);
    if (!out.str().empty()) say(out.str());
    if (!err.str().empty()) say_aside(err.str());
    return code == 0 ? ExitCode::ok : ExitCode::bad_input;
  }
  return action();
}

/// Whether who read our output has gone away, as `head` does after its lines: no fault of ours.
bool reader_left() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

}  // namespace

int run_cli(int argc, const char* const* argv) {
  ExitCode code = ExitCode::bug;
  try {
    code = run_command(argc, argv);
    if ((std::fflush(stdout) != 0 || std::ferror(stdout) != 0) && !reader_left())
      throw Error("the output cannot be written");
  } catch (const Error& error) {
    say_aside(std::string("lightbench: error: ") + error.what());
    code = ExitCode::bad_input;
  } catch (const std::bad_alloc&) {
    say_aside("lightbench: error: out of memory");
    code = ExitCode::bad_input;
  } catch (const std::exception& error) {
    say_aside(std::string("lightbench: bug: ") + error.what());
  }
  return static_cast<int>(code);
}

}  // namespace lightbench
