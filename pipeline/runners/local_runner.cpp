#include "pipeline/runners/local_runner.h"

#include "base/error.h"
#include "base/text.h"

namespace lightbench {

std::string last_lines(const std::string& text, std::size_t count) {
  std::vector<std::string> lines;
  for (const auto& line : split(text, '\n'))
    if (!trimmed(line).empty()) lines.push_back(trimmed(line));
  if (lines.size() > count) lines.erase(lines.begin(), lines.end() - std::ptrdiff_t(count));
  return join(lines, " | ");
}

LocalRunner::LocalRunner(std::filesystem::path program, std::filesystem::path plan_file,
                         std::filesystem::path scratch)
    : program_(std::move(program)), plan_file_(std::move(plan_file)), scratch_(std::move(scratch)) {
  std::error_code error;
  std::filesystem::remove_all(scratch_, error);
  if (!error) std::filesystem::create_directories(scratch_, error);
  if (error) throw Error("cannot make a folder for temporary files: " + error.message(), scratch_.string());
}

LocalRunner::~LocalRunner() {
  std::error_code ignored;
  std::filesystem::remove_all(scratch_, ignored);
}

void LocalRunner::start(const std::vector<const Task*>& tasks, LineHandler on_line, EndHandler on_end) {
  ProcessOptions options;
  options.argv = {program_.string(), "work", plan_file_.string()};
  double seconds = 0;
  for (const Task* task : tasks) {
    options.argv.push_back(task->id);
    seconds += task->timeout_seconds;
  }
  // As many workers run as there are cores, so each has one thread.
  options.environment = {{"LP_NUM_THREADS", "1"},
                         {"OMP_NUM_THREADS", "1"},
                         {"OPENIMAGEIO_THREADS", "1"},
                         {"TMPDIR", scratch_.string()}};
  options.timeout = std::chrono::milliseconds(static_cast<long long>(seconds * 1000));
  loop_.start(options, std::move(on_line), [on_end = std::move(on_end)](const ProcessResult& result) {
    on_end({result.ok(), result.describe(), last_lines(result.err, 3)});
  });
}

void LocalRunner::every(std::chrono::milliseconds interval, std::function<void()> tick) {
  loop_.every(interval, tick);
}

}  // namespace lightbench
