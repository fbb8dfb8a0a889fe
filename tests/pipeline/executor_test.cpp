#include "pipeline/executor.h"

#include <deque>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "job_fixture.h"

namespace lightbench {
namespace {

using test::index_of;
using ::testing::Contains;
using ::testing::HasSubstr;

/// Knows only what it was told.
class FakeCache : public Cache {
 public:
  std::optional<LedgerEntry> find(const Task& task) override {
    const auto found = entries.find(task.id);
    if (found == entries.end() || found->second.key != task.key || found->second.outcome != Outcome::ok)
      return std::nullopt;
    return found->second;
  }
  std::string why_missing(const Task&) override { return ""; }
  std::optional<std::string> last_failure(const Task& task) override {
    const auto found = entries.find(task.id);
    if (found == entries.end() || found->second.outcome == Outcome::ok) return std::nullopt;
    return found->second.error;
  }
  std::optional<double> last_seconds(const Task&) override { return std::nullopt; }
  void record(const LedgerEntry& entry) override {
    if (full) throw Error("no space left", "ledger.jsonl");
    entries[entry.id] = entry;
  }

  std::map<std::string, LedgerEntry> entries;
  bool full = false;
};

/// Workers that do what a script says, one step of one worker after the other.
class FakeRunner : public Runner {
 public:
  void start(const std::vector<const Task*>& tasks, LineHandler on_line, EndHandler on_end) override {
    workers_.push_back({{tasks.begin(), tasks.end()}, std::move(on_line), std::move(on_end)});
    most_workers = std::max(most_workers, workers_.size());
    ++workers_started;
  }
  void every(std::chrono::milliseconds, std::function<void()>) override {}
  bool interrupted() const override { return stopped; }

  void run() override {
    while (!workers_.empty()) {
      Worker worker = std::move(workers_.front());
      workers_.pop_front();
      if (step(worker)) workers_.push_back(std::move(worker));
    }
  }

  std::set<std::string> failing;  ///< these say why they fail
  std::string failing_words = "\"no light\"";
  std::set<std::string> crashing;                              ///< in these the worker dies
  std::map<std::string, std::vector<std::string>> more_lines;  ///< what these say after their answer
  std::map<std::string, std::string> answers;  ///< what these say behind the id instead of a plain result
  bool dies_at_start = false;
  std::size_t interrupt_after = 1000;  ///< tasks
  bool stopped = false;
  std::vector<std::string> begun;
  std::size_t most_workers = 0;
  std::size_t workers_started = 0;

 private:
  struct Worker {
    std::deque<const Task*> tasks;
    LineHandler on_line;
    EndHandler on_end;
  };

  bool step(Worker& worker) {
    if (dies_at_start) return end(worker, {false, "killed by signal 11", "libGL is broken"});
    if (stopped) return end(worker, {false, "killed by signal 15", ""});
    if (worker.tasks.empty()) return end(worker, {true, "exit code 0", ""});
    const std::string id = worker.tasks.front()->id;
    worker.tasks.pop_front();
    begun.push_back(id);
    worker.on_line("start " + id);
    if (begun.size() > interrupt_after) {
      stopped = true;
      return true;
    }
    if (crashing.contains(id)) return end(worker, {false, "killed by signal 9", "line before the end"});
    worker.on_line("a library says hello");
    if (failing.contains(id))
      worker.on_line("fail " + id + " " + failing_words);
    else if (answers.contains(id))
      worker.on_line("done " + id + " " + answers.at(id));
    else
      worker.on_line("done " + id + R"( {"seconds": 1, "outputs": {}})");
    for (const auto& line : more_lines[id]) worker.on_line(line);
    return true;
  }

  static bool end(Worker& worker, const WorkerEnd& end) {
    worker.on_end(end);
    return false;
  }

  std::deque<Worker> workers_;
};

class QuietWatcher : public Watcher {
 public:
  void begin(const Schedule&) override {}
  void workers(std::size_t) override {}
  void started(const Task&) override {}
  void ended(const Task&, const TaskOutcome&) override {}
  void tick() override {}
  void finish() override {}
};

class Execute : public ::testing::Test {
 protected:
  std::vector<TaskOutcome> run() { return execute(plan_, cache_, runner_, watcher_, options_); }
  std::size_t index(const std::string& id) const { return index_of(plan_, id); }
  static std::size_t count(const std::vector<TaskOutcome>& outcomes, TaskState state) {
    return std::size_t(
        std::count_if(outcomes.begin(), outcomes.end(), [&](const auto& o) { return o.state == state; }));
  }

  Plan plan_ = test::plan_of(test::concrete_job());
  FakeCache cache_;
  FakeRunner runner_;
  QuietWatcher watcher_;
  ExecuteOptions options_{.places = 2, .memory_mb = 1 << 20, .selected = {}};
};

TEST_F(Execute, DoesEverythingOnce) {
  const auto outcomes = run();
  EXPECT_EQ(count(outcomes, TaskState::done), plan_.tasks.size());
  EXPECT_EQ(std::set(runner_.begun.begin(), runner_.begun.end()).size(), plan_.tasks.size());
  EXPECT_EQ(runner_.begun.size(), plan_.tasks.size());
}

TEST_F(Execute, ASecondRunDoesNothing) {
  run();
  runner_.begun.clear();
  const auto outcomes = run();
  EXPECT_EQ(count(outcomes, TaskState::cached), plan_.tasks.size());
  EXPECT_TRUE(runner_.begun.empty());
}

TEST_F(Execute, NoMoreWorkersThanPlaces) {
  options_.places = 3;
  run();
  EXPECT_EQ(runner_.most_workers, 3u);
}

TEST_F(Execute, WorkersShareASceneWithoutStartingForEachTask) {
  run();
  // 6 snapshots, 5 exports and 6 scores in groups; 3 references alone.
  EXPECT_LE(runner_.workers_started, 9u);
}

TEST_F(Execute, AFailedTaskIsOneFailureAndWhatNeedsItIsSkipped) {
  runner_.failing = {"snapshot:one/a/other"};
  const auto outcomes = run();
  EXPECT_EQ(outcomes[index("snapshot:one/a/other")].state, TaskState::failed);
  EXPECT_EQ(outcomes[index("snapshot:one/a/other")].reason, "no light");
  EXPECT_EQ(outcomes[index("score:one/a/other/truth")].state, TaskState::skipped);
  EXPECT_EQ(count(outcomes, TaskState::done), plan_.tasks.size() - 2);
}

TEST_F(Execute, AFailedTaskIsTriedAgainByTheNextRun) {
  runner_.failing = {"snapshot:one/a/other"};
  run();
  runner_.failing.clear();
  runner_.begun.clear();
  run();
  EXPECT_THAT(runner_.begun, ::testing::ElementsAre("snapshot:one/a/other", "score:one/a/other/truth"));
}

TEST_F(Execute, WhatFailedBeforeAndIsNotAskedForIsToldWithItsReason) {
  const std::size_t picture = index("snapshot:one/a/other"), score = index("score:one/a/other/truth");
  runner_.failing = {"snapshot:one/a/other"};
  run();
  runner_.begun.clear();
  options_.selected.assign(plan_.tasks.size(), false);
  options_.selected[score] = true;
  const auto outcomes = run();
  EXPECT_TRUE(runner_.begun.empty());
  EXPECT_EQ(outcomes[picture].state, TaskState::failed);
  EXPECT_EQ(outcomes[picture].reason, "in an earlier run: no light");
  EXPECT_EQ(outcomes[score].state, TaskState::skipped);
  EXPECT_THAT(outcomes[score].reason, HasSubstr("which failed: in an earlier run: no light"));
}

TEST_F(Execute, WhatFailedBeforeAndIsNotNeededIsNotTold) {
  runner_.failing = {"snapshot:one/a/other"};
  run();
  options_.selected.assign(plan_.tasks.size(), false);
  options_.selected[index("score:two/a/direct/truth")] = true;
  EXPECT_EQ(run()[index("snapshot:one/a/other")].state, TaskState::skipped);
}

TEST_F(Execute, ADeadWorkerLosesOnlyTheTaskThatItHadBegun) {
  runner_.crashing = {"snapshot:one/a/direct"};
  const auto outcomes = run();
  EXPECT_EQ(count(outcomes, TaskState::failed), 1u);
  const auto& lost = outcomes[index("snapshot:one/a/direct")];
  EXPECT_THAT(lost.reason, HasSubstr("killed by signal 9"));
  EXPECT_THAT(lost.reason, HasSubstr("line before the end"));
  // Both scores of that view need it: one as its picture, one as its baseline.
  EXPECT_EQ(count(outcomes, TaskState::skipped), 2u);
}

TEST_F(Execute, WorkersThatDieBeforeAnyTaskEndTheRun) {
  runner_.dies_at_start = true;
  const auto outcomes = run();
  EXPECT_EQ(count(outcomes, TaskState::done), 0u);
  EXPECT_EQ(count(outcomes, TaskState::waiting), 0u);
  EXPECT_THAT(outcomes[index("snapshot:one/a/direct")].reason, HasSubstr("libGL is broken"));
}

TEST_F(Execute, AnAnswerThatCannotBeReadIsAFailureOfItsTaskAlone) {
  const std::string id = "snapshot:two/a/other";
  for (const char* answer : {"{", "", "{}", "[]", "null", "7", R"({"seconds": "long", "outputs": {}})",
                             R"({"seconds": 1, "outputs": []})", R"({"seconds": 1, "outputs": {"a": 7}})",
                             R"({"seconds": 1, "outputs": {}, "metrics": {"gain": {}}})"}) {
    cache_.entries.clear();
    runner_.answers = {{id, answer}};
    const auto outcomes = run();
    EXPECT_EQ(outcomes[index(id)].state, TaskState::failed) << answer;
    EXPECT_THAT(outcomes[index(id)].reason, HasSubstr("the worker's answer cannot be read")) << answer;
    EXPECT_EQ(count(outcomes, TaskState::failed), 1u) << answer;
    EXPECT_EQ(outcomes[index("snapshot:one/a/direct")].state, TaskState::done) << answer;
  }
}

TEST_F(Execute, ATaskThatIsSaidToBeDoneTwiceIsDoneOnce) {
  const std::string id = "snapshot:two/a/other";
  const std::string result = R"({"seconds": 1, "outputs": {}})";
  runner_.more_lines[id] = {"start " + id, "done " + id + " " + result, "fail " + id + R"( "late")"};
  const auto outcomes = run();
  EXPECT_EQ(outcomes[index(id)].state, TaskState::done);
  EXPECT_EQ(count(outcomes, TaskState::done), plan_.tasks.size());
}

TEST_F(Execute, AReasonThatIsNoTextIsAFailureToo) {
  runner_.failing = {"snapshot:two/a/other"};
  runner_.failing_words = "{}";
  EXPECT_EQ(run()[index("snapshot:two/a/other")].state, TaskState::failed);
}

TEST_F(Execute, WhatReadAChangedPictureHasFailed) {
  const std::string picture = "views/one/a/direct.exr";
  runner_.answers["snapshot:one/a/direct"] =
      R"({"seconds": 1, "outputs": {")" + picture + R"(": "as it was made"}})";
  const std::string score = "score:one/a/direct/truth";
  runner_.answers[score] =
      R"({"seconds": 1, "outputs": {}, "inputs": {")" + picture + R"(": "something else"}})";
  const auto outcomes = run();
  EXPECT_EQ(outcomes[index(score)].state, TaskState::failed);
  EXPECT_THAT(outcomes[index(score)].reason, HasSubstr(picture + " was changed while the run went on"));
}

TEST_F(Execute, WhatReadThePictureThatWasMadeIsDone) {
  const std::string picture = "views/one/a/direct.exr";
  runner_.answers["snapshot:one/a/direct"] = R"({"seconds": 1, "outputs": {")" + picture + R"(": "same"}})";
  const std::string score = "score:one/a/direct/truth";
  runner_.answers[score] = R"({"seconds": 1, "outputs": {}, "inputs": {")" + picture + R"(": "same"}})";
  EXPECT_EQ(run()[index(score)].state, TaskState::done);
}

TEST_F(Execute, AnInterruptedRunKeepsWhatIsDoneAndGoesOnLater) {
  runner_.interrupt_after = 5;
  const auto first = run();
  const std::size_t done = count(first, TaskState::done);
  EXPECT_GE(done, 4u);
  EXPECT_EQ(count(first, TaskState::done) + count(first, TaskState::skipped), plan_.tasks.size());
  runner_.stopped = false;
  runner_.interrupt_after = 1000;
  const auto second = run();
  EXPECT_EQ(count(second, TaskState::cached), done);
  EXPECT_EQ(count(second, TaskState::done), plan_.tasks.size() - done);
}

TEST_F(Execute, WhatCannotBeDoneIsNotStarted) {
  plan_.tasks[index("snapshot:one/b/direct")].refused = "area lights";
  const auto outcomes = run();
  EXPECT_EQ(outcomes[index("snapshot:one/b/direct")].reason, "area lights");
  EXPECT_THAT(runner_.begun, ::testing::Not(Contains("snapshot:one/b/direct")));
}

TEST_F(Execute, TasksThatRunBesideOthersAreMarked) {
  const auto outcomes = run();
  EXPECT_TRUE(outcomes[index("reference:one/a/truth")].entry->contended);
  cache_.entries.clear();
  options_.places = 1;
  for (const auto& outcome : run()) EXPECT_FALSE(outcome.entry->contended);
}

TEST_F(Execute, AFullDiskEndsTheRun) {
  cache_.full = true;
  EXPECT_THROW(run(), Error);
}

}  // namespace
}  // namespace lightbench
