#include "base/input_file.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"

namespace lightbench {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(InputFile, ReadsAFileToItsEnd) {
  const TemporaryFolder folder;
  write_file_atomic(folder.path() / "a", "hello");
  InputFile file(folder.path() / "a");
  EXPECT_EQ(file.size(), 5u);
  std::string bytes(10, '-');
  EXPECT_EQ(file.read(bytes), 5u);
  EXPECT_EQ(bytes, "hello-----");
}

TEST(InputFile, WhatHasNoEndIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const fs::path fifo = folder.path() / "fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const auto is_fifo =
      ThrowsMessage<Error>(AllOf(HasSubstr("not a regular file (a FIFO)"), HasSubstr("fifo:")));
  EXPECT_THAT([&] { read_file(fifo); }, is_fifo);
  EXPECT_THAT([&] { hash_file(fifo); }, is_fifo);
  EXPECT_THAT([] { read_file("/dev/zero"); }, ThrowsMessage<Error>(HasSubstr("a device")));
  EXPECT_THAT([] { hash_file("/dev/zero"); }, ThrowsMessage<Error>(HasSubstr("a device")));
}

TEST(InputFile, ASocketIsNamedAsSuch) {
  const TemporaryFolder folder;
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = (folder.path() / "socket").string();
  ASSERT_LT(path.size(), sizeof address.sun_path);
  path.copy(address.sun_path, path.size());
  ASSERT_EQ(::bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_THAT([&] { read_file(path); }, ThrowsMessage<Error>(HasSubstr("a socket")));
  ::close(descriptor);
}

TEST(InputFile, AFolderAndAMissingFileAreNamed) {
  EXPECT_THAT([] { read_file("/tmp"); }, ThrowsMessage<Error>(HasSubstr("is a folder, not a file")));
  EXPECT_THAT([] { read_file("/nowhere/at/all"); }, ThrowsMessage<Error>(HasSubstr("No such file")));
}

TEST(InputFile, ASparseFileBeyondTheLimitIsRefusedUnread) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "sparse";
  write_file_atomic(file, "");
  fs::resize_file(file, 1'000'000'000'000);
  const auto too_large =
      ThrowsMessage<Error>(AllOf(HasSubstr("has 1 TB"), HasSubstr("at most 64 MB are read")));
  EXPECT_THAT([&] { read_file(file, kLargestTextFile); }, too_large);
  EXPECT_THAT([&] { hash_file(file, kLargestTextFile); }, too_large);
}

TEST(InputFile, AFileOfTheLimitIsRead) {
  const TemporaryFolder folder;
  write_file_atomic(folder.path() / "a", "12345");
  EXPECT_EQ(read_file(folder.path() / "a", 5), "12345");
  EXPECT_THROW(read_file(folder.path() / "a", 4), Error);
}

TEST(InputFile, SizesAreToldInUnits) {
  EXPECT_EQ(bytes_text(0), "0 bytes");
  EXPECT_EQ(bytes_text(1), "1 byte");
  EXPECT_EQ(bytes_text(999), "999 bytes");
  EXPECT_EQ(bytes_text(64'000'000), "64 MB");
  EXPECT_EQ(bytes_text(1'234'567'890), "1.235 GB");
}

}  // namespace
}  // namespace lightbench
