#include "renderer/radiance/baked_file.h"

#include <cerrno>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "tests/base/failing_files.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

class BakedFiles : public ::testing::Test {
 protected:
  void SetUp() override { write_file_atomic(file_, "old"); }

  void write() { BakedFile(file_, "mti", header_, std::as_bytes(std::span(entries_)), files_).commit(); }

  void expect_error_that_keeps_the_old_file() {
    try {
      write();
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("wall.mti"));
    }
    EXPECT_EQ(read_file(file_), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "wall.mti";
  std::vector<std::uint16_t> entries_ = std::vector<std::uint16_t>(30'000, 7);
  BakedHeader header_{300, 100, {2, 2, LayerOrder::theta_major}, 1, 1, 16, entries_.size()};
  test::FailingFiles files_;
};

TEST_F(BakedFiles, ADiskThatFillsUpAnywhereKeepsTheOldFile) {
  for (std::size_t room = 0; room < header_.file_bytes(); room += room < kBakedHeaderBytes ? 8 : 4'001) {
    files_.room = room;
    ASSERT_NO_FATAL_FAILURE(expect_error_that_keeps_the_old_file()) << room;
  }
  files_.room = header_.file_bytes() - 1;
  expect_error_that_keeps_the_old_file();
  files_.room = header_.file_bytes();
  write();
  EXPECT_EQ(BakedReader(file_, "mti").read<std::uint16_t>(), entries_);
}

TEST_F(BakedFiles, EveryFailedCallKeepsTheOldFile) {
  for (int* const call :
       {&files_.failing_create, &files_.failing_sync, &files_.failing_close, &files_.failing_rename}) {
    *call = EIO;
    expect_error_that_keeps_the_old_file();
    *call = 0;
  }
}

TEST_F(BakedFiles, OneThatIsNotCommittedIsNotThere) {
  { const BakedFile file(file_, "mti", header_, std::as_bytes(std::span(entries_))); }
  EXPECT_EQ(read_file(file_), "old");
}

}  // namespace
}  // namespace lightbench
