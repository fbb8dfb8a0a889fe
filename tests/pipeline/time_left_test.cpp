#include "pipeline/time_left.h"

#include <gtest/gtest.h>

namespace lightbench {
namespace {

/// Snapshots of 1 ms in one group.
struct Snapshots {
  explicit Snapshots(std::size_t count) : tasks(count) {
    for (std::size_t i = 0; i < count; ++i) {
      tasks[i].id = std::to_string(i);
      tasks[i].group = "scene";
    }
    schedule = std::make_unique<Schedule>(tasks, std::vector<double>(count, 0.001));
  }

  /// Ends so many tasks, each of which took `own` seconds.
  void end(std::size_t count, double own, TimeLeft& left) {
    while (count > 0)
      for (const std::size_t task : schedule->next_batch(1, 0, false)) {
        if (count == 0) {
          schedule->give_back(task);
          continue;
        }
        schedule->done(task);
        left.task_ended(tasks[task].kind, schedule->seconds(task), own);
        --count;
      }
  }

  std::vector<Task> tasks;
  std::unique_ptr<Schedule> schedule;
};

TEST(TimeLeft, TimeOfWorkersOutsideTasksIsExpectedOfTheOtherTasksToo) {
  Snapshots run(2600);
  TimeLeft left(*run.schedule);
  run.end(1300, 0.001, left);
  // Each task cost its worker 0.1 s, of which it knows 1 ms; the other half of them will take as long.
  EXPECT_NEAR(left.seconds(*run.schedule, 1, {.workers = 130}), 130, 1);
  EXPECT_NEAR(left.seconds(*run.schedule, 2, {.workers = 130}), 65, 0.5);
}

TEST(TimeLeft, StartsOfWorkersCountBeforeTheFirstTask) {
  Snapshots run(10);
  for (Task& task : run.tasks) task.group = "";
  EXPECT_GT(TimeLeft(*run.schedule).seconds(*run.schedule, 1, {}), 1) << "ten starts and ten milliseconds";
  for (Task& task : run.tasks) task.group = "scene";
  EXPECT_LT(TimeLeft(*run.schedule).seconds(*run.schedule, 1, {}), 1) << "one start";
}

TEST(TimeLeft, ALongTaskThatRunsIsNoOverhead) {
  Snapshots run(100);
  TimeLeft left(*run.schedule);
  run.end(10, 0.001, left);
  const double before = left.seconds(*run.schedule, 1, {.workers = 0.01});
  EXPECT_NEAR(left.seconds(*run.schedule, 1, {.workers = 1000.01, .unended = 1000, .expected = 0}), before,
              1e-9);
}

TEST(TimeLeft, OfARunThatIsDoneIsNothing) {
  Snapshots run(3);
  TimeLeft left(*run.schedule);
  run.end(3, 0.5, left);
  EXPECT_EQ(left.seconds(*run.schedule, 1, {.workers = 7}), 0);
}

TEST(TimeLeft, KindsGoAtTheirOwnPace) {
  Snapshots run(4);
  TimeLeft left(*run.schedule);
  EXPECT_EQ(left.pace(TaskKind::snapshot), 1);
  left.task_ended(TaskKind::reference, 1, 4);
  EXPECT_EQ(left.pace(TaskKind::reference), 4);
  EXPECT_EQ(left.pace(TaskKind::snapshot), 1);
}

}  // namespace
}  // namespace lightbench
