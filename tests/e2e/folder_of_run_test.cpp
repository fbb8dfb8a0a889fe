#include "run_fixture.h"

namespace lightbench {
namespace {

using test::GlRun;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(GlRun, AFolderWithHiddenFilesAloneIsTaken) {
  write("out/.gitkeep", "");
  EXPECT_EQ(run_job().exit_code, 0);
  std::filesystem::remove(path("out/ledger.jsonl"));
  EXPECT_EQ(run_job().exit_code, 0) << "the folder of a run that begins anew";
}

TEST_F(GlRun, ViewsThatTheJobHasNoMoreAreInNoReport) {
  EXPECT_EQ(run_job().exit_code, 0);
  write("cameras.json",
        R"({"views": [{"name": "front", "position": [0.5, 0.5, 4], "look_at": [0.5, 0.5, 0]}]})");
  EXPECT_EQ(run_job().exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("out/views/box/side"))) << "pictures stay, as they may be wanted";
  for (const char* report : {"index.html", "run.json", "junit.xml", "summary.md"}) {
    const std::string text = read_file(path("out") / report);
    EXPECT_THAT(text, HasSubstr("front")) << report;
    EXPECT_THAT(text, Not(HasSubstr("box/side"))) << report;
  }
}

}  // namespace
}  // namespace lightbench
