#include "base/atomic_file.h"

#include <cerrno>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/error.h"
#include "base/files.h"
#include "failing_files.h"

namespace lightbench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Half a million bytes, in pieces.
constexpr std::size_t kPieces = 5;
const std::string kPiece(100'000, 'n');

class AtomicFiles : public ::testing::Test {
 protected:
  void write() {
    AtomicFile file(target_, files_);
    for (std::size_t i = 0; i < kPieces; ++i) file.write(kPiece);
    file.commit();
  }

  std::string error_of_write() {
    try {
      write();
    } catch (const Error& error) {
      EXPECT_EQ(error.where(), target_.string());
      return error.message();
    }
    return "no error";
  }

  /// The target has its old content, and nothing lies beside it.
  void expect_untouched() const {
    EXPECT_EQ(read_file(target_), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
  }

  void expect_written() const {
    EXPECT_EQ(fs::file_size(target_), kPieces * kPiece.size());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
  }

  void SetUp() override { write_file_atomic(target_, "old"); }

  TemporaryFolder folder_;
  fs::path target_ = folder_.path() / "target.png";
  test::FailingFiles files_;
};

TEST_F(AtomicFiles, ADiskThatFillsUpAnywhereKeepsTheOldContent) {
  for (std::size_t room = 0; room < kPieces * kPiece.size(); room += 17'321) {
    files_.room = room;
    EXPECT_EQ(error_of_write(), "cannot write: No space left on device") << room;
    expect_untouched();
  }
}

TEST_F(AtomicFiles, TheLastByteCounts) {
  files_.room = kPieces * kPiece.size() - 1;
  EXPECT_THAT(error_of_write(), HasSubstr("No space left"));
  expect_untouched();
  files_.room = kPieces * kPiece.size();
  write();
  expect_written();
}

TEST_F(AtomicFiles, ShortAndInterruptedWritesGoOn) {
  files_.most_at_a_time = 7'000;
  files_.interrupts = 3;
  write();
  expect_written();
}

TEST_F(AtomicFiles, EveryFailedCallKeepsTheOldContent) {
  for (int* const call : {&files_.failing_create, &files_.failing_sync, &files_.failing_size,
                          &files_.failing_close, &files_.failing_rename}) {
    *call = EIO;
    EXPECT_THAT(error_of_write(), HasSubstr("Input/output error"));
    expect_untouched();
    *call = 0;
  }
}

TEST_F(AtomicFiles, AFileThatIsShorterThanWhatWasWrittenIsAnError) {
  files_.lost_bytes = 1;
  EXPECT_THAT(error_of_write(), HasSubstr("499999 of 500000 bytes"));
  expect_untouched();
}

TEST_F(AtomicFiles, AFolderThatCannotBeSyncedIsAnErrorUnlessFoldersHaveNoSuchThing) {
  files_.failing_folder_sync = EIO;
  EXPECT_THAT(error_of_write(), HasSubstr("Input/output error"));
  expect_written();  // it has its name already
  files_.failing_folder_sync = EINVAL;
  write();
}

TEST_F(AtomicFiles, ATakenTemporaryNameIsNotOverwritten) {
  files_.taken_names = 2;
  write();
  expect_written();
}

TEST_F(AtomicFiles, WithoutACommitNothingStays) {
  {
    AtomicFile file(target_);
    file.write("half");
    file.finish();
  }
  expect_untouched();
}

TEST_F(AtomicFiles, LongNamesFit) {
  const fs::path file = folder_.path() / (std::string(250, 'x') + ".png");
  AtomicFile(file).commit();
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(AtomicFiles, PipesAndDevicesAreNotReplaced) {
  const fs::path pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink("/dev/null", folder_.path() / "null");
  for (const fs::path& file : {pipe, folder_.path() / "null"})
    EXPECT_THROW(write_file_atomic(file, "x"), Error);
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "null"));
}

}  // namespace
}  // namespace lightbench
