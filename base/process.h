#pragma once

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

/// A child process: arguments as a vector (never a shell), a process group of its own, killed with its
/// parent.
struct ProcessOptions {
  std::vector<std::string> argv;              ///< argv[0] is looked up on the PATH unless it has a slash
  std::filesystem::path working_directory{};  ///< empty: ours
  std::map<std::string, std::string> environment{};  ///< added to ours
  std::string input{};                               ///< what it reads from its standard input
  std::chrono::milliseconds timeout{0};              ///< 0: none; at the end TERM, and KILL 2 s later
  std::chrono::milliseconds idle_timeout{
      0};                               ///< 0: none; likewise, once it used no processor time for so long
  std::size_t keep_output = 1 << 20;    ///< last bytes kept of each stream
  std::size_t longest_line = 16 << 20;  ///< what stands behind so many bytes of a line is left out
};

struct ProcessResult {
  int exit_code = -1;  ///< -1 when a signal ended it
  int signal = 0;      ///< 0 when it ended by itself
  bool timed_out = false;
  bool stalled = false;    ///< ended by idle_timeout
  double seconds = 0;      ///< wall clock
  double cpu_seconds = 0;  ///< user + system, with waited-for children
  std::string out;
  std::string err;

  bool ok() const { return exit_code == 0; }
  /// "exit code 3", "killed by signal 9", "timed out after 5 s", "stalled: ...".
  std::string describe() const;
};

/// Runs children side by side and calls back on one thread.
class ProcessLoop {
 public:
  using LineHandler = std::function<void(std::string_view line)>;
  using ExitHandler = std::function<void(const ProcessResult&)>;

  ProcessLoop();
  ProcessLoop(const ProcessLoop&) = delete;
  ProcessLoop& operator=(const ProcessLoop&) = delete;
  ~ProcessLoop();  ///< kills what still runs

  /// Throws Error when the program does not exist or cannot be started. `on_line` gets each line of standard
  /// output; both handlers may start further children.
  void start(const ProcessOptions& options, LineHandler on_line, ExitHandler on_exit);
  /// Calls `tick` at the interval for as long as `run` runs.
  void every(std::chrono::milliseconds interval, const std::function<void()>& tick);
  /// Returns when no child is left. On INT, TERM or HUP all children are terminated and `interrupted` is set;
  /// those of them that the process ignores (nohup, a background job of a shell) stay ignored.
  void run();
  bool interrupted() const;
  /// TERM to every child's group, KILL 2 s later.
  void terminate_all();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One child, waited for. Throws Error when it cannot be started.
ProcessResult run_process(const ProcessOptions& options);

/// User and system time that this process has used, with its threads and the children it has waited for.
double own_cpu_seconds();

/// The program's file as the PATH gives it, or an empty path.
std::filesystem::path find_program(const std::string& name);

}  // namespace lightbench
