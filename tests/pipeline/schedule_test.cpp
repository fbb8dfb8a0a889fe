#include "pipeline/schedule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lightbench {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Task task(const std::string& id, std::vector<std::size_t> deps = {}, const std::string& group = "") {
  Task result;
  result.id = id;
  result.deps = std::move(deps);
  result.group = group;
  return result;
}

TEST(Schedule, TheLongestWayToTheEndComesFirst) {
  const std::vector<Task> tasks = {task("short"), task("long"), task("start of a chain"),
                                   task("end of it", {2})};
  Schedule schedule(tasks, {1, 5, 2, 4});
  EXPECT_THAT(schedule.next_batch(1, 0, false), ElementsAre(2));
  EXPECT_THAT(schedule.next_batch(1, 0, false), ElementsAre(1));
  EXPECT_THAT(schedule.next_batch(1, 0, false), ElementsAre(0));
  EXPECT_THAT(schedule.next_batch(1, 0, false), IsEmpty());
}

TEST(Schedule, ATaskWaitsForWhatItNeeds) {
  const std::vector<Task> tasks = {task("a"), task("b", {0})};
  Schedule schedule(tasks, {1, 1});
  schedule.next_batch(1, 0, false);
  EXPECT_THAT(schedule.next_batch(1, 0, false), IsEmpty());
  schedule.done(0);
  EXPECT_THAT(schedule.next_batch(1, 0, false), ElementsAre(1));
}

TEST(Schedule, WhatIsThereAlreadyNeedNotBeDone) {
  const std::vector<Task> tasks = {task("a"), task("b", {0})};
  Schedule schedule(tasks, {1, 1});
  schedule.set_cached(0);
  EXPECT_THAT(schedule.next_batch(1, 0, false), ElementsAre(1));
}

TEST(Schedule, TasksOfOneGroupGoTogether) {
  const std::vector<Task> tasks = {task("a", {}, "x"), task("b", {}, "y"), task("c", {}, "x")};
  Schedule schedule(tasks, {0.3, 0.2, 0.1});
  EXPECT_THAT(schedule.next_batch(1, 0, false), ElementsAre(0, 2));
  EXPECT_THAT(schedule.next_batch(1, 0, false), ElementsAre(1));
}

TEST(Schedule, TasksWithoutAGroupGoAlone) {
  const std::vector<Task> tasks = {task("a"), task("b")};
  Schedule schedule(tasks, {0.1, 0.1});
  EXPECT_THAT(schedule.next_batch(1, 0, false), ElementsAre(0));
}

TEST(Schedule, ALargeGroupIsSharedByTheWorkers) {
  const std::vector<Task> tasks(12, task("t", {}, "scene"));
  Schedule schedule(tasks, std::vector<double>(12, 1.0));
  EXPECT_EQ(schedule.next_batch(3, 0, false).size(), 4u);
}

TEST(Schedule, AFailureSkipsWhatNeedsItAndNothingElse) {
  const std::vector<Task> tasks = {task("a"), task("b", {0}), task("c", {1}), task("d")};
  Schedule schedule(tasks, {4, 3, 2, 1});
  schedule.next_batch(1, 0, false);
  schedule.fail(0, "no light\nat all");
  EXPECT_EQ(schedule.state(1), TaskState::skipped);
  EXPECT_EQ(schedule.state(2), TaskState::skipped);
  EXPECT_EQ(schedule.reason(2), "needs a, which failed: no light");
  EXPECT_THAT(schedule.next_batch(1, 0, false), ElementsAre(3));
}

TEST(Schedule, ASkippedTaskSkipsWhatNeedsItUnlessThatIsThere) {
  const std::vector<Task> tasks = {task("a"), task("b", {0}), task("c", {0})};
  Schedule schedule(tasks, {1, 1, 1});
  schedule.set_cached(1);
  schedule.skip(0, "not asked for");
  EXPECT_EQ(schedule.state(1), TaskState::cached);
  EXPECT_EQ(schedule.reason(2), "needs a: not asked for");
}

TEST(Schedule, WhatWasNotBegunIsHandedOutAgain) {
  const std::vector<Task> tasks = {task("a")};
  Schedule schedule(tasks, {1});
  schedule.next_batch(1, 0, false);
  schedule.give_back(0);
  EXPECT_THAT(schedule.next_batch(1, 0, false), ElementsAre(0));
}

TEST(Schedule, WhatNeedsTooMuchMemoryWaitsUntilItIsAlone) {
  std::vector<Task> tasks = {task("large"), task("small")};
  tasks[0].resources.memory_mb = 1000;
  Schedule schedule(tasks, {5, 1});
  EXPECT_THAT(schedule.next_batch(2, 500, true), ElementsAre(1));
  EXPECT_THAT(schedule.next_batch(2, 500, true), IsEmpty());
  EXPECT_THAT(schedule.next_batch(2, 500, false), ElementsAre(0));
}

RC_GTEST_PROP(ScheduleProperty, EveryTaskIsHandedOutOnceAndAfterWhatItNeeds, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 30);
  std::vector<Task> tasks;
  std::vector<double> seconds;
  for (std::size_t i = 0; i < count; ++i) {
    tasks.push_back(task("t", {}, std::string(1, char('a' + *rc::gen::inRange(0, 3)))));
    if (i > 0 && *rc::gen::arbitrary<bool>()) tasks.back().deps = {*rc::gen::inRange<std::size_t>(0, i)};
    seconds.push_back(*rc::gen::inRange(0, 100) / 10.0);
  }
  Schedule schedule(tasks, seconds);
  std::vector<bool> done(count, false);
  std::size_t handed_out = 0;
  for (auto batch = schedule.next_batch(2, 0, false); !batch.empty();
       batch = schedule.next_batch(2, 0, false))
    for (const std::size_t i : batch) {
      for (const std::size_t dep : tasks[i].deps) RC_ASSERT(done[dep]);
      RC_ASSERT(!done[i]);
      schedule.done(i);
      done[i] = true;
      ++handed_out;
    }
  RC_ASSERT(handed_out == count);
}

}  // namespace
}  // namespace lightbench
