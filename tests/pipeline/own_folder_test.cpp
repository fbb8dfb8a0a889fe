#include "pipeline/own_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "job_fixture.h"
#include "pipeline/plan_file.h"

namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class OwnFolder : public ::testing::Test {
 protected:
  void write(const std::string& name) const { write_file_atomic(folder_.path() / name, "x"); }

  std::string refusal() const {
    try {
      check_own_folder(folder_.path());
    } catch (const Error& error) {
      return error.what();
    }
    return "it was taken";
  }

  const TemporaryFolder folder_;
};

TEST_F(OwnFolder, OfFilesWithoutARunIsRefused) {
  write("notes.txt");
  write("index.html");
  EXPECT_THAT(refusal(), AllOf(HasSubstr(folder_.path().string()), HasSubstr("such as index.html"),
                               HasSubstr("no run of lightbench")));
}

TEST_F(OwnFolder, OfAFolderWithoutARunIsRefused) {
  write("src/main.cpp");
  EXPECT_THAT(refusal(), HasSubstr("such as src"));
}

TEST_F(OwnFolder, MayBeMissingOrEmpty) {
  EXPECT_EQ(refusal(), "it was taken");
  EXPECT_NO_THROW(check_own_folder(folder_.path() / "new"));
}

TEST_F(OwnFolder, MayHaveHiddenFiles) {
  write(".gitkeep");
  write(".cache/file");
  EXPECT_EQ(refusal(), "it was taken");
}

TEST_F(OwnFolder, OfARunIsTakenWhateverElseIsThere) {
  write("notes.txt");
  write_file_atomic(folder_.path() / "plan.json", plan_to_json(test::plan_of(test::concrete_job())));
  EXPECT_EQ(refusal(), "it was taken") << "its ledger was removed to begin anew";
  write("ledger.jsonl");
  EXPECT_EQ(refusal(), "it was taken");
}

TEST_F(OwnFolder, WithThePlanOfAnotherProgramIsRefused) {
  write_file_atomic(folder_.path() / "plan.json", R"({"terraform_version": "1.5"})");
  EXPECT_THAT(refusal(), HasSubstr("such as plan.json"));
}

TEST_F(OwnFolder, MayHaveWhatBenchWroteBeforeTheFirstRun) {
  write("bench.json");
  EXPECT_EQ(refusal(), "it was taken");
}

}  // namespace
}  // namespace lightbench
