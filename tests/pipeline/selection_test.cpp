#include "pipeline/selection.h"

#include <gmock/gmock.h>

#include "job_fixture.h"

namespace lightbench {
namespace {

class Select : public ::testing::Test {
 protected:
  std::set<std::string> selected(const std::set<TaskKind>& stages, const std::string& only) const {
    return ids_of(select_tasks(plan_, stages, only));
  }
  /// What is tried again when these tasks failed, and all others were done.
  std::set<std::string> after_failures(const std::set<std::string>& failed) const {
    std::map<std::string, LedgerEntry> last;
    for (const Task& task : plan_.tasks)
      last[task.id].outcome = failed.contains(task.id) ? Outcome::failed : Outcome::ok;
    return ids_of(select_failed(plan_, last));
  }
  std::set<std::string> ids_of(const std::vector<bool>& flags) const {
    std::set<std::string> ids;
    for (std::size_t i = 0; i < flags.size(); ++i)
      if (flags[i]) ids.insert(plan_.tasks[i].id);
    return ids;
  }

  Plan plan_ = test::plan_of(test::concrete_job());
};

TEST_F(Select, EverythingWithoutAWish) {
  EXPECT_EQ(selected({}, "").size(), plan_.tasks.size());
}

TEST_F(Select, AStageAlone) {
  EXPECT_EQ(selected({TaskKind::snapshot}, "").size(), 6u);
}

TEST_F(Select, TheReferenceStageHasItsExports) {
  EXPECT_EQ(selected({TaskKind::reference}, "two/*"),
            (std::set<std::string>{"export:two/povray", "export:two/a/truth", "reference:two/a/truth"}));
}

TEST_F(Select, APatternBringsWhatItsTasksNeed) {
  EXPECT_EQ(selected({}, "one/a/other"),
            (std::set<std::string>{"snapshot:one/a/other", "score:one/a/other/truth", "snapshot:one/a/direct",
                                   "reference:one/a/truth", "export:one/povray", "export:one/a/truth"}));
}

TEST_F(Select, AViewBringsAllThatBelongsToIt) {
  EXPECT_EQ(selected({}, "two/a").size(), 7u);
}

TEST_F(Select, AStageIsNotLeftForWhatItsTasksNeed) {
  EXPECT_EQ(selected({TaskKind::score}, "two/a").size(), 2u);
}

TEST_F(Select, NothingMatchesNothing) {
  EXPECT_TRUE(selected({}, "three*").empty());
}

TEST_F(Select, NothingIsRetriedWhereNothingFailed) {
  EXPECT_TRUE(after_failures({}).empty());
}

TEST_F(Select, AFailedReferenceIsRetriedWithItsScores) {
  EXPECT_EQ(after_failures({"reference:two/a/truth"}),
            (std::set<std::string>{"export:two/povray", "export:two/a/truth", "reference:two/a/truth",
                                   "snapshot:two/a/direct", "snapshot:two/a/other",
                                   "score:two/a/direct/truth", "score:two/a/other/truth"}));
}

TEST_F(Select, AFailedScoreIsRetriedAlone) {
  EXPECT_EQ(after_failures({"score:two/a/direct/truth"}),
            (std::set<std::string>{"score:two/a/direct/truth", "snapshot:two/a/direct",
                                   "reference:two/a/truth", "export:two/povray", "export:two/a/truth"}));
}

}  // namespace
}  // namespace lightbench
