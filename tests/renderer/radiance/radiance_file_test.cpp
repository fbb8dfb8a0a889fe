#include "renderer/radiance/radiance_file.h"

#include <csignal>
#include <limits>

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>
#include <sys/resource.h>

#include "base/error.h"
#include "tests/base/small_disk.h"
#include "tests/renderer/radiance/damage.h"
#include "tests/renderer/radiance/random_stacks.h"

namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

template <typename Component>
void expect_equal(const RadianceStack<Component>& a, const RadianceStack<Component>& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.grid, b.grid);
  EXPECT_EQ(a.scale, b.scale);
  EXPECT_EQ(a.texels, b.texels);
}

ByteStack small_stack() {
  return random_stack(Content::noise, {3, 2, LayerOrder::phi_major}, 3, 2, 1);
}

class RadianceFile : public ::testing::Test {
 protected:
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "wall.mtex";
};

TEST_F(RadianceFile, BytesComeBack) {
  write_radiance(file, small_stack());
  expect_equal(read_byte_radiance(file), small_stack());
}

TEST_F(RadianceFile, HalvesComeBackBitByBit) {
  HalfStack stack{2, 1, {2, 2, LayerOrder::theta_major}, 3.5f, {}};
  for (std::uint16_t i = 0; i < 8; ++i) stack.texels.push_back({i, std::uint16_t(0x3c00 + i), 0x7bff});
  write_radiance(file, stack);
  expect_equal(read_half_radiance(file), stack);
}

RC_GTEST_PROP(RadianceFileProperty, AnyStackComesBack, ()) {
  const TemporaryFolder folder;
  const ByteStack stack = any_stack();
  write_radiance(folder.path() / "a.mtex", stack);
  expect_equal(read_byte_radiance(folder.path() / "a.mtex"), stack);
}

TEST_F(RadianceFile, HeaderTellsTheKindOfTexels) {
  write_radiance(file, small_stack());
  const BakedHeader header = read_radiance_header(file);
  EXPECT_EQ(header.bits, 8);
  EXPECT_EQ(header.width, 3);
  EXPECT_EQ(header.height, 2);
  EXPECT_EQ(header.grid, small_stack().grid);
  EXPECT_EQ(header.scale, 1.5f);
  write_radiance(file, HalfStack{1, 1, {2, 1}, 1, {{1, 2, 3}, {4, 5, 6}}});
  EXPECT_EQ(read_radiance_header(file).bits, 16);
}

TEST_F(RadianceFile, LayoutIsTheDocumentedOne) {
  write_radiance(
      file,
      ByteStack{
          2, 1, {2, 1, LayerOrder::phi_serpentine}, 1, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}}});
  const std::string expected(
      "lb-mtex\0\1\0\0\0\2\0\0\0\1\0\0\0\2\0\0\0\2\0\0\0\1\0\0\0\2\0\0\0\3\0\10\0\0\0\200\77\4\0\0\0"
      "\1\2\3\4\5\6\7\10\11\12\13\14",
      60);
  EXPECT_EQ(read_file(file), expected);
}

TEST_F(RadianceFile, OneKindIsNotReadAsTheOther) {
  write_radiance(file, small_stack());
  EXPECT_THAT([&] { read_half_radiance(file); },
              ThrowsMessage<Error>(AllOf(HasSubstr("wall.mtex"), HasSubstr("3 components of 8 bits"))));
}

TEST_F(RadianceFile, EveryTruncationIsAnError) {
  write_radiance(file, small_stack());
  const std::string bytes = read_file(file);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    overwrite(file, bytes.substr(0, length));
    EXPECT_THROW(read_byte_radiance(file), Error) << length;
    EXPECT_THROW(read_radiance_header(file), Error) << length;
  }
}

TEST_F(RadianceFile, TrailingBytesAreAnError) {
  write_radiance(file, small_stack());
  overwrite(file, read_file(file) + '\0');
  EXPECT_THAT([&] { read_byte_radiance(file); }, ThrowsMessage<Error>(HasSubstr("157 bytes, but 156")));
}

TEST_F(RadianceFile, EveryDamagedFieldIsAnErrorThatNamesTheFile) {
  write_radiance(file, small_stack());
  for (const Damage& damage : damaged_headers(read_file(file))) {
    overwrite(file, damage.bytes);
    EXPECT_THAT([&] { read_byte_radiance(file); }, ThrowsMessage<Error>(HasSubstr("wall.mtex")))
        << damage.what;
  }
}

TEST_F(RadianceFile, DepthMustBeThetasTimesPhis) {
  write_radiance(file, small_stack());
  overwrite(file, with_field<std::uint32_t>(read_file(file), 24, 2));
  EXPECT_THAT([&] { read_byte_radiance(file); }, ThrowsMessage<Error>(HasSubstr("2 thetas times 2 phis")));
}

TEST_F(RadianceFile, HugeSizesOfASmallFileAreNotAllocated) {
  write_radiance(file, small_stack());
  std::string bytes = read_file(file);
  bytes = with_field<std::uint32_t>(with_field<std::uint32_t>(bytes, 12, 16384), 16, 16384);
  bytes = with_field<std::uint32_t>(bytes, 44, 0xffffffff);
  overwrite(file, bytes);
  EXPECT_THAT([&] { read_byte_radiance(file); },
              ThrowsMessage<Error>(HasSubstr("12884901933 by its header")));
}

TEST_F(RadianceFile, WhatCouldNotBeReadIsNotWritten) {
  ByteStack stack = small_stack();
  stack.scale = std::numeric_limits<float>::infinity();
  EXPECT_THROW(write_radiance(file, stack), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(RadianceFile, MissingFilesAndFoldersAreErrors) {
  EXPECT_THAT([&] { read_byte_radiance(file); }, ThrowsMessage<Error>(HasSubstr("wall.mtex")));
  EXPECT_THAT([&] { read_radiance_header(folder.path()); },
              ThrowsMessage<Error>(HasSubstr(folder.path().string())));
}

TEST_F(RadianceFile, OnAFullDiskItIsWholeOrTheOldOne) {
  const ByteStack stack = random_stack(Content::noise, {5, 4}, 20, 20, 2);
  if (!test::with_small_disk([&](const test::SmallDisk& disk) {
        test::expect_whole_or_old(disk, "wall.mtex",
                                  [&](const auto& target) { write_radiance(target, stack); });
      }))
    GTEST_SKIP() << test::kNoMounts;
}

/// Files may not grow beyond `bytes`, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

TEST_F(RadianceFile, AFullDiskIsAnErrorAndLeavesWhatWasThere) {
  write_radiance(file, small_stack());
  const ByteStack large = random_stack(Content::noise, {20, 20}, 20, 20, 2);
  {
    const FullDisk full(100'000);
    EXPECT_THAT([&] { write_radiance(file, large); },
                ThrowsMessage<Error>(AllOf(HasSubstr("wall.mtex"), HasSubstr("cannot write"))));
  }
  expect_equal(read_byte_radiance(file), small_stack());
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace lightbench
