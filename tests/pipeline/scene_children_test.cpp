#include "pipeline/scene_children.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "job_fixture.h"
#include "pipeline/scene_facts_file.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

/// A stand-in for the program: a shell script that is called as `inspect JOB SCENE OUTPUT`.
class SceneChildrenOf : public ::testing::Test {
 protected:
  SceneChildren children(const std::string& script) {
    const auto program = folder_.path() / "program";
    write_file_atomic(program, "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    return SceneChildren(program, 2);
  }
  /// What a script does whose scene is fine.
  std::string facts(std::size_t triangles) {
    SceneFacts facts;
    facts.triangles = triangles;
    const auto file = folder_.path() / "facts.json";
    write_file_atomic(file, scene_facts_to_json(facts));
    return "cp '" + file.string() + "' \"$4\"";
  }

  TemporaryFolder folder_;
  Job job_ = test::concrete_job();  // of two scenes
};

TEST_F(SceneChildrenOf, EachSceneHasTheFactsOfItsChild) {
  const auto all = children(facts(7)).inspect(job_);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].triangles, 7u);
  EXPECT_EQ(all[1].triangles, 7u);
}

TEST_F(SceneChildrenOf, ASceneThatKillsItsChildIsOneScenesError) {
  const auto all =
      children("[ \"$3\" = 0 ] && { echo 'last words' >&2; kill -SEGV $$; }\n" + facts(7)).inspect(job_);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_THAT(all[0].error, HasSubstr("the process that read it ended: killed by signal 11"));
  EXPECT_THAT(all[0].error, HasSubstr("last words"));
  EXPECT_EQ(all[0].triangles, 0u);
  EXPECT_EQ(all[1].error, "");
  EXPECT_EQ(all[1].triangles, 7u);
}

TEST_F(SceneChildrenOf, AChildWithoutFactsIsAnErrorToo) {
  for (const auto& facts : children("exit 0").inspect(job_)) EXPECT_NE(facts.error, "");
  for (const auto& facts : children("echo '{}' > \"$4\"").inspect(job_)) EXPECT_NE(facts.error, "");
  for (const auto& facts : children("echo 'out of memory' >&2; exit 3").inspect(job_))
    EXPECT_THAT(facts.error, HasSubstr("exit code 3; it said last: out of memory"));
}

TEST_F(SceneChildrenOf, ViewsThatCannotBeDrawnTellWhy) {
  const JobScene& scene = job_.scenes.front();
  try {
    children("echo 'lightbench: error: one.json: no valid view was found' >&2; exit 3")
        .draw_views(job_, scene, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "one.json: no valid view was found");
  }
  EXPECT_THROW(children("kill -KILL $$").draw_views(job_, scene, {}), Error);
}

TEST_F(SceneChildrenOf, TheChildThatDrawsIsToldWhichGenerator) {
  RandomViewsRequest request;
  request.version = 1;
  try {
    children("echo \"$@\" >&2; exit 3").draw_views(job_, job_.scenes.front(), request);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("--generator=1"));
  }
}

}  // namespace
}  // namespace lightbench
