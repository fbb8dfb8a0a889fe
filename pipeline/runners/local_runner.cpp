#include "pipeline/runners/local_runner.h"

#include "base/text.h"

namespace lightbench {

std::string last_lines(const std::string& text, std::size_t count) {
  std::vector<std::string> lines;
  for (const auto& line : split(text, '\n'))
    if (!trimmed(line).empty()) lines.push_back(trimmed(line));
  if (lines.size() > count) lines.erase(lines.begin(), lines.end() - std::ptrdiff_t(count));
  return join(lines, " | ");
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
  options.environment = {{"LP_NUM_THREADS", "1"}, {"OMP_NUM_THREADS", "1"}, {"OPENIMAGEIO_THREADS", "1"}};
  options.timeout = std::chrono::milliseconds(static_cast<long long>(seconds * 1000));
  loop_.start(options, std::move(on_line), [on_end = std::move(on_end)](const ProcessResult& result) {
    on_end({result.ok(), result.describe(), last_lines(result.err, 3)});
  });
}

void LocalRunner::every(std::chrono::milliseconds interval, std::function<void()> tick) {
  loop_.every(interval, tick);
}

}  // namespace lightbench
