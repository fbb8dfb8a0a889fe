#include "pipeline/runners/local_runner.h"

#include <gtest/gtest.h>

#include "base/files.h"

namespace lightbench {
namespace {

/// A worker that says that it has done each task.
constexpr const char* kWorker =
    "#!/bin/sh\n[ \"$1 $2\" = 'work plan.json' ] || exit 1\nsed 's/^/done /; s/$/ {}/'\n";

TEST(LocalRunner, ThousandsOfLongIdsReachTheirWorker) {
  const TemporaryFolder folder;
  const auto program = folder.path() / "worker";
  write_file_atomic(program, kWorker);
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  std::vector<Task> tasks(30'000);
  std::vector<const Task*> batch;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    tasks[i].id = "score:" + std::string(120, 'x') + "/" + std::to_string(i);
    tasks[i].timeout_seconds = 1;
    batch.push_back(&tasks[i]);
  }
  LocalRunner runner(program, "plan.json", folder.path());
  std::size_t done = 0;
  WorkerEnd end;
  runner.start(
      batch, [&](std::string_view line) { done += line == "done " + tasks[done].id + " {}"; },
      [&](const WorkerEnd& e) { end = e; });
  runner.run();
  EXPECT_TRUE(end.ok) << end.how << end.last_words;
  EXPECT_EQ(done, tasks.size());
}

TEST(LocalRunner, LastWordsAreShort) {
  const TemporaryFolder folder;
  const auto program = folder.path() / "worker";
  write_file_atomic(program, "#!/bin/sh\nhead -c 1000000 /dev/zero | tr '\\0' x >&2; exit 1\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  Task task;
  task.timeout_seconds = 60;
  LocalRunner runner(program, "plan.json", folder.path());
  WorkerEnd end;
  runner.start({&task}, nullptr, [&](const WorkerEnd& e) { end = e; });
  runner.run();
  EXPECT_EQ(end.how, "exit code 1");
  EXPECT_LT(end.last_words.size(), 1000u);
}

}  // namespace
}  // namespace lightbench
