#include "base/orphans.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/files.h"

namespace lightbench {
namespace {

namespace fs = std::filesystem;

TEST(Orphans, AreKnownByTheNameThatAtomicFileGives) {
  for (const char* name : {"x.png", "x", "a.tmp-1-2.png", "name with.many.dots.exr"}) {
    const TemporaryFolder folder;
    AtomicFile file(folder.path() / name);
    file.write("half");
    for (const auto& entry : fs::directory_iterator(folder.path()))
      EXPECT_TRUE(is_temporary_name(entry.path().filename().string())) << entry.path();
    EXPECT_FALSE(fs::is_empty(folder.path()));
  }
}

TEST(Orphans, OtherNamesAreNot) {
  for (const char* name : {"", ".", ".tmp-1-2.png", "x.tmp-1-2.png", ".x.tmp-1.png", ".x.tmp-1-.png",
                           ".x.tmp--2", ".x.tmp-1-2png", ".x.tmp-a-b.png", "truth.png", ".x.png"})
    EXPECT_FALSE(is_temporary_name(name)) << name;
}

TEST(Orphans, AreRemovedWithoutFollowingLinks) {
  const TemporaryFolder folder, elsewhere;
  const fs::path run = folder.path() / "views";
  write_file_atomic(run / "box" / ".truth.tmp-12-3.exr", "half");
  write_file_atomic(run / "box" / "truth.exr", "whole");
  write_file_atomic(elsewhere.path() / ".theirs.tmp-12-3.exr", "theirs");
  fs::create_directory_symlink(elsewhere.path(), run / "link");
  fs::create_directory_symlink(elsewhere.path(), folder.path() / "baked");
  remove_orphans(run);
  remove_orphans(folder.path() / "baked");
  remove_orphans(folder.path() / "nothing there");
  EXPECT_FALSE(fs::exists(run / "box" / ".truth.tmp-12-3.exr"));
  EXPECT_TRUE(fs::exists(run / "box" / "truth.exr"));
  EXPECT_TRUE(fs::exists(elsewhere.path() / ".theirs.tmp-12-3.exr"));
}

TEST(Orphans, OfTheFolderAlone) {
  const TemporaryFolder folder;
  write_file_atomic(folder.path() / ".plan.tmp-12-3.json", "half");
  write_file_atomic(folder.path() / "below" / ".plan.tmp-12-3.json", "half");
  remove_orphans_in(folder.path());
  EXPECT_FALSE(fs::exists(folder.path() / ".plan.tmp-12-3.json"));
  EXPECT_TRUE(fs::exists(folder.path() / "below" / ".plan.tmp-12-3.json"));
}

}  // namespace
}  // namespace lightbench
