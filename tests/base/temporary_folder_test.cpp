#include "base/temporary_folder.h"

#include <csignal>
#include <cstdlib>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/files.h"

namespace lightbench {
namespace {

namespace fs = std::filesystem;

/// A place for temporary files that only this test uses.
class TemporaryFolders : public ::testing::Test {
 protected:
  TemporaryFolders() { ::setenv("TMPDIR", place_.path().c_str(), 1); }
  ~TemporaryFolders() override {
    if (before_) ::setenv("TMPDIR", before_->c_str(), 1);
    if (!before_) ::unsetenv("TMPDIR");
  }

  std::size_t count() const { return std::size_t(std::distance(fs::directory_iterator(place_.path()), {})); }

  /// Makes a temporary folder with a file in it in a process that is killed then.
  static void leave_one() {
    const pid_t child = ::fork();
    if (child == 0) {
      const TemporaryFolder folder;
      write_file_atomic(folder.path() / "deep" / "file", "x");
      ::raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
  }

  const TemporaryFolder place_;
  const std::optional<std::string> before_ =
      std::getenv("TMPDIR") ? std::optional<std::string>(std::getenv("TMPDIR")) : std::nullopt;
};

TEST_F(TemporaryFolders, AreRemoved) {
  fs::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    write_file_atomic(path / "deep" / "file", "x");
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(TemporaryFolders, TheNextOneRemovesWhatAKilledProcessLeft) {
  leave_one();
  ASSERT_EQ(count(), 1u);
  const TemporaryFolder folder;
  EXPECT_EQ(count(), 1u);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST_F(TemporaryFolders, OnesThatAreInUseStay) {
  const TemporaryFolder first;
  const TemporaryFolder second;
  EXPECT_TRUE(fs::exists(first.path()));
  EXPECT_EQ(count(), 2u);
}

TEST_F(TemporaryFolders, FoldersOfOthersStay) {
  leave_one();
  std::string stale = fs::directory_iterator(place_.path())->path().filename().string();
  fs::create_directory(place_.path() / "lightbench-notes");
  fs::create_directory(place_.path() / ("x" + stale));                 // of another program
  fs::create_directory(place_.path() / "lightbench-00000000-abcdef");  // of another machine
  fs::create_directory(place_.path() / "target");
  fs::create_directory_symlink("target", place_.path() / stale.replace(stale.size() - 6, 6, "linked"));
  const TemporaryFolder folder;
  EXPECT_EQ(count(), 6u);
}

}  // namespace
}  // namespace lightbench
