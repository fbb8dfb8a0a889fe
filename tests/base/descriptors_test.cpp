#include "base/descriptors.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/files.h"

namespace lightbench {
namespace {

/// Whether what the child process finds is as it should be.
template <typename Check>
bool holds_in_child(Check check) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(check() ? 0 : 1);
  int status = 0;
  return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(Descriptors, ClosedStandardOnesAreOpened) {
  for (const int closed : {0, 1, 2})
    EXPECT_TRUE(holds_in_child([&] {
      ::close(closed);
      open_standard_descriptors();
      const Descriptor next = file_in_memory("");
      return next.number() > STDERR_FILENO && ::write(1, "", 0) == 0 && ::write(2, "", 0) == 0;
    })) << closed;
  EXPECT_TRUE(holds_in_child([] {
    for (const int closed : {0, 1, 2}) ::close(closed);
    open_standard_descriptors();
    return file_in_memory("").number() > STDERR_FILENO;
  }));
}

TEST(Descriptors, OpenOnesAreLeftAlone) {
  EXPECT_TRUE(holds_in_child([] {
    const Descriptor file = file_in_memory("the input");
    ::dup2(file.number(), STDIN_FILENO);
    open_standard_descriptors();
    char text[9] = {};
    return ::read(STDIN_FILENO, text, sizeof text) == 9 && std::string_view(text, 9) == "the input";
  }));
}

TEST(FolderLock, KeepsOthersOutUntilItsEnd) {
  const TemporaryFolder parent;
  const auto folder = parent.path() / "folder";
  std::filesystem::create_directory(folder);
  {
    const FolderLock first(folder);
    EXPECT_EQ(first.state(), Locked::yes);
    EXPECT_EQ(FolderLock(folder).state(), Locked::by_another);
  }
  EXPECT_EQ(FolderLock(folder).state(), Locked::yes);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(FolderLock, LinksAndFilesAreNotLocked) {
  const TemporaryFolder parent;
  std::filesystem::create_directory_symlink(parent.path(), parent.path() / "link");
  write_file_atomic(parent.path() / "file", "");
  for (const char* name : {"link", "file", "nothing"})
    EXPECT_EQ(FolderLock(parent.path() / name).state(), Locked::unknown) << name;
}

}  // namespace
}  // namespace lightbench
