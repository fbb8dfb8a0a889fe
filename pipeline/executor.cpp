#include "pipeline/executor.h"

#include <algorithm>
#include <cassert>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/json_bytes.h"
#include "base/text.h"

namespace lightbench {
namespace {

struct Worker {
  std::vector<std::size_t> tasks;
  std::optional<std::size_t> current;
  bool began = false;
};

class Execution {
 public:
  Execution(const Plan& plan, Cache& cache, Runner& runner, Watcher& watcher, const ExecuteOptions& options)
      : plan_(plan),
        cache_(cache),
        runner_(runner),
        watcher_(watcher),
        options_(options),
        schedule_(plan.tasks, expected_seconds()),
        entries_(plan.tasks.size()),
        contended_(plan.tasks.size(), false) {
    for (std::size_t i = 0; i < plan.tasks.size(); ++i) index_[plan.tasks[i].id] = i;
  }

  std::vector<TaskOutcome> run() {
    sort_out();
    watcher_.begin(schedule_);
    runner_.every(std::chrono::milliseconds(500), [this] { watcher_.tick(); });
    fill();
    runner_.run();
    stop();
    watcher_.finish();
    std::vector<TaskOutcome> outcomes;
    for (std::size_t i = 0; i < plan_.tasks.size(); ++i) outcomes.push_back(outcome(i));
    return outcomes;
  }

 private:
  std::vector<double> expected_seconds() const {
    std::vector<double> result;
    for (const auto& task : plan_.tasks)
      result.push_back(cache_.last_seconds(task).value_or(task.expected_seconds));
    return result;
  }

  TaskOutcome outcome(std::size_t i) const {
    return {schedule_.state(i), schedule_.reason(i), schedule_.seconds(i), entries_[i]};
  }

  /// What is there already, what is not wanted, and what cannot be done.
  void sort_out() {
    for (std::size_t i = 0; i < plan_.tasks.size(); ++i)
      if ((entries_[i] = cache_.find(plan_.tasks[i]))) schedule_.set_cached(i);
    const std::vector<bool> needed = needed_by_selected();
    for (std::size_t i = 0; i < plan_.tasks.size(); ++i) {
      if (schedule_.state(i) != TaskState::waiting) continue;
      if (!options_.selected.empty() && !options_.selected[i])
        leave_out(i, needed[i]);
      else if (!plan_.tasks[i].refused.empty())
        fail(i, plan_.tasks[i].refused);
    }
  }

  /// What the selected tasks need, whether it is selected or not.
  std::vector<bool> needed_by_selected() const {
    std::vector<bool> needed = options_.selected;
    for (std::size_t i = needed.size(); i-- > 0;)
      if (needed[i])
        for (const std::size_t dep : plan_.tasks[i].deps) needed[dep] = true;
    return needed;
  }

  /// A task that is not asked for is skipped. Where one that is asked for needs it, its failure in an earlier
  /// run is told, since that is why the other cannot be done.
  void leave_out(std::size_t i, bool is_needed) {
    const auto reason = is_needed ? cache_.last_failure(plan_.tasks[i]) : std::nullopt;
    if (reason)
      schedule_.fail(i, "in an earlier run: " + *reason);
    else
      schedule_.skip(i, "not asked for, and not there from an earlier run");
  }

  void fill() {
    while (!runner_.interrupted() && int(workers_.size()) < options_.places) {
      const auto batch = schedule_.next_batch(options_.places, free_memory(), !workers_.empty());
      if (batch.empty()) return;
      const int number = next_worker_++;
      workers_[number].tasks = batch;
      for (const auto& [other, worker] : workers_)
        if (worker.current) contended_[*worker.current] = true;
      std::vector<const Task*> tasks;
      for (const std::size_t i : batch) tasks.push_back(&plan_.tasks[i]);
      runner_.start(
          tasks, [this, number](std::string_view line) { on_line(number, line); },
          [this, number](const WorkerEnd& end) { on_end(number, end); });
      watcher_.workers(workers_.size());
    }
  }

  int free_memory() const {
    int used = 0;
    for (const auto& [number, worker] : workers_) {
      int most = 0;
      for (const std::size_t i : worker.tasks) most = std::max(most, plan_.tasks[i].resources.memory_mb);
      used += most;
    }
    return options_.memory_mb - used;
  }

  void on_line(int number, std::string_view line) {
    const auto space = line.find(' ');
    if (space == std::string_view::npos) return;
    const std::string_view word = line.substr(0, space);
    if (word != "start" && word != "done" && word != "fail") return;
    const std::string_view rest = line.substr(space + 1);
    const auto id_end = rest.find(' ');
    const auto found = index_.find(std::string(rest.substr(0, id_end)));
    Worker& worker = workers_.at(number);
    if (found == index_.end() ||
        std::find(worker.tasks.begin(), worker.tasks.end(), found->second) == worker.tasks.end())
      return;
    const std::size_t task = found->second;
    const std::string_view payload = id_end == std::string_view::npos ? "" : rest.substr(id_end + 1);
    if (word == "start") return begin(worker, task);
    if (worker.current != task) return;
    worker.current.reset();
    end_task(word == "done", task, payload);
    fill();
  }

  /// A task that was ended cannot begin once more.
  void begin(Worker& worker, std::size_t task) {
    if (schedule_.state(task) != TaskState::running) return;
    worker.current = task;
    worker.began = true;
    contended_[task] = workers_.size() > 1;
    watcher_.started(plan_.tasks[task]);
  }

  void end_task(bool ok, std::size_t task, std::string_view payload) {
    std::string error;
    if (auto result = read_answer(ok, task, payload, error))
      succeed(task, std::move(*result));
    else
      fail(task, error);
  }

  /// A worker may say anything; what is not the result of its task is the error of that task alone.
  std::optional<TaskResult> read_answer(bool ok, std::size_t task, std::string_view payload,
                                        std::string& error) const {
    try {
      const auto json = parse_json_text(payload);
      if (!ok) {
        error = json.get<std::string>();
        return std::nullopt;
      }
      TaskResult result = task_result_from_json(json, plan_.tasks[task].id);
      error = changed_input(task, result);
      if (error.empty()) return result;
    } catch (const nlohmann::json::exception&) {
      error = "the worker's answer cannot be read";
    } catch (const Error& unreadable) {
      error = "the worker's answer cannot be read: " + unreadable.message();
    }
    return std::nullopt;
  }

  /// What the task read must be what the tasks before it wrote; else its result does not belong to its key.
  std::string changed_input(std::size_t task, const TaskResult& result) const {
    for (const std::size_t dep : plan_.tasks[task].deps) {
      if (!entries_[dep]) continue;
      for (const auto& [file, hash] : entries_[dep]->result.outputs) {
        const auto read = result.inputs.find(file);
        if (read != result.inputs.end() && read->second != hash)
          return file + " was changed while the run went on; the next run makes it again";
      }
    }
    return "";
  }

  LedgerEntry entry_for(std::size_t i) const {
    const Task& task = plan_.tasks[i];
    LedgerEntry entry;
    entry.id = task.id;
    entry.key = task.key;
    entry.key_parts = task.key_parts;
    entry.contended = contended_[i];
    entry.ended = utc_now();
    return entry;
  }

  void succeed(std::size_t i, TaskResult result) {
    LedgerEntry entry = entry_for(i);
    entry.result = std::move(result);
    cache_.record(entry);
    entries_[i] = std::move(entry);
    schedule_.done(i);
    watcher_.ended(plan_.tasks[i], outcome(i));
  }

  void fail(std::size_t i, const std::string& error) {
    LedgerEntry entry = entry_for(i);
    entry.outcome = Outcome::failed;
    entry.error = error;
    cache_.record(entry);
    schedule_.fail(i, error);
    watcher_.ended(plan_.tasks[i], outcome(i));
  }

  /// Only the task that a dead worker had begun has failed; one that dies before any task fails its first, or
  /// it would be started again for ever.
  void on_end(int number, const WorkerEnd& end) {
    const Worker worker = std::move(workers_.at(number));
    workers_.erase(number);
    watcher_.workers(workers_.size());
    if (!runner_.interrupted()) {
      std::optional<std::size_t> lost = worker.current;
      if (!lost && !worker.began) lost = worker.tasks.front();
      if (lost) {
        const std::string words = end.last_words.empty() ? "" : "; it said last: " + end.last_words;
        fail(*lost, "its worker ended: " + end.how + words);
      }
    }
    for (const std::size_t i : worker.tasks)
      if (schedule_.state(i) == TaskState::running) schedule_.give_back(i);
    fill();
  }

  /// After the last worker: whatever still waits was interrupted.
  void stop() {
    for (std::size_t i = 0; i < plan_.tasks.size(); ++i)
      if (schedule_.state(i) == TaskState::waiting) schedule_.skip(i, "the run was interrupted");
  }

  const Plan& plan_;
  Cache& cache_;
  Runner& runner_;
  Watcher& watcher_;
  const ExecuteOptions& options_;
  Schedule schedule_;
  std::vector<std::optional<LedgerEntry>> entries_;
  std::vector<bool> contended_;
  std::map<std::string, std::size_t> index_;
  std::map<int, Worker> workers_;
  int next_worker_ = 0;
};

}  // namespace

std::vector<TaskOutcome> execute(const Plan& plan, Cache& cache, Runner& runner, Watcher& watcher,
                                 const ExecuteOptions& options) {
  return Execution(plan, cache, runner, watcher, options).run();
}

}  // namespace lightbench
