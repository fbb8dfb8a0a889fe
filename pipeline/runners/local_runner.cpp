#include "pipeline/runners/local_runner.h"

#include <cassert>

#include "base/text.h"

namespace lightbench {

LocalRunner::LocalRunner(std::filesystem::path program, std::filesystem::path plan_file,
                         std::filesystem::path scratch)
    : program_(std::move(program)), plan_file_(std::move(plan_file)), scratch_(std::move(scratch)) {}

void LocalRunner::start(const std::vector<const Task*>& tasks, LineHandler on_line, EndHandler on_end) {
  ProcessOptions options;
  options.argv = {program_.string(), "work", plan_file_.string()};
  double seconds = 0;
  for (const Task* task : tasks) {
    assert(task->id.find('\n') == std::string::npos);  // names are escaped in it
    options.input += task->id + "\n";
    seconds += task->timeout_seconds;
  }
  // As many workers run as there are cores, so each has one thread.
  options.environment = {{"LP_NUM_THREADS", "1"},
                         {"OMP_NUM_THREADS", "1"},
                         {"OPENIMAGEIO_THREADS", "1"},
                         {"TMPDIR", scratch_.string()}};
  options.timeout = std::chrono::milliseconds(static_cast<long long>(seconds * 1000));
  loop_.start(options, std::move(on_line), [on_end = std::move(on_end)](const ProcessResult& result) {
    on_end({result.ok(), result.describe(), join(last_lines(result.err, 3), " | ")});
  });
}

void LocalRunner::every(std::chrono::milliseconds interval, std::function<void()> tick) {
  loop_.every(interval, tick);
}

}  // namespace lightbench
