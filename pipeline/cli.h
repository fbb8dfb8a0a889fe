#pragma once

namespace lightbench {

/// The whole program: parses the command line, runs the command, and is the one place that catches. Returns
/// an ExitCode.
int run_cli(int argc, const char* const* argv);

}  // namespace lightbench
