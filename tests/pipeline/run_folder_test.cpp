#include "pipeline/run_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "job_fixture.h"

namespace lightbench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class RunFolder : public ::testing::Test {
 protected:
  RunFolder() : plan_(make_plan(job_, test::facts_for(job_), folder_.path() / "out")) {
    fs::create_directory(plan_.out);
    fs::create_directory(elsewhere());
  }

  fs::path elsewhere() const { return folder_.path() / "elsewhere"; }
  fs::path out(const std::string& name) const { return plan_.out / name; }
  void link(const std::string& name) const {
    fs::create_directories(out(name).parent_path());
    fs::create_directory_symlink(elsewhere(), out(name));
  }
  std::string refusal() const {
    try {
      const Workspace workspace(plan_);
    } catch (const Error& error) {
      return error.what();
    }
    return "it was taken";
  }

  const TemporaryFolder folder_;
  const Job job_ = test::concrete_job();
  const Plan plan_;
};

TEST_F(RunFolder, LinksOnTheWayToFilesAreRefused) {
  for (const char* name : {"views", "views/one", "views/one/b", "povray", "povray/two"}) {
    link(name);
    EXPECT_THAT(refusal(), HasSubstr(out(name).string() + ": is a link")) << name;
    fs::remove(out(name));
  }
  EXPECT_TRUE(fs::is_empty(elsewhere()));
  const Workspace workspace(plan_);
}

TEST_F(RunFolder, ItselfMayBeALink) {
  fs::remove(plan_.out);
  fs::create_directory_symlink(elsewhere(), plan_.out);
  const Workspace workspace(plan_);
  EXPECT_TRUE(fs::is_directory(workspace.scratch()));
}

TEST_F(RunFolder, AFileInPlaceOfAFolderIsRefused) {
  write_file_atomic(out("views"), "");
  EXPECT_THAT(refusal(), HasSubstr("is in the place of a folder"));
}

TEST_F(RunFolder, ATaskIsCheckedForItself) {
  link("views/one/b");
  EXPECT_THROW(check_output_folders(plan_, test::task_called(plan_, "snapshot:one/b/direct")), Error);
  EXPECT_NO_THROW(check_output_folders(plan_, test::task_called(plan_, "snapshot:one/a/direct")));
}

TEST_F(RunFolder, WhatKilledWorkersLeftIsRemovedAtTheStartAndAtTheEnd) {
  const std::vector<std::string> left = {
      ".lightbench-tmp/lightbench-x/file", ".plan.tmp-7-0.json", "views/one/a/.direct.tmp-7-1.exr",
      "baked/one/x/.0001-box.tmp-7-0.mtex", "povray/one/.mesh_1.tmp-7-0.inc"};
  const auto leave = [&] {
    for (const auto& file : left) write_file_atomic(out(file), "half");
  };
  const auto expect_gone = [&] {
    for (const auto& file : left) EXPECT_FALSE(fs::exists(out(file))) << file;
  };
  leave();
  {
    const Workspace workspace(plan_);
    expect_gone();
    EXPECT_TRUE(fs::is_empty(workspace.scratch()));
    leave();
  }
  expect_gone();
  EXPECT_FALSE(fs::exists(out(".lightbench-tmp")));
}

TEST_F(RunFolder, FilesOfOthersStay) {
  const std::vector<std::string> theirs = {"tmp/notes", "mine/.direct.tmp-7-1.exr", "views/one/a/mine.exr"};
  for (const auto& file : theirs) write_file_atomic(out(file), "theirs");
  write_file_atomic(elsewhere() / ".direct.tmp-7-1.exr", "theirs");
  link("baked");
  link(".lightbench-tmp");
  { const Workspace workspace(plan_); }
  for (const auto& file : theirs) EXPECT_TRUE(fs::exists(out(file))) << file;
  EXPECT_TRUE(fs::exists(elsewhere() / ".direct.tmp-7-1.exr"));
}

}  // namespace
}  // namespace lightbench
