#include "base/hash.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"

namespace lightbench {
namespace {

TEST(Hash, FieldsAreDelimited) {
  EXPECT_NE(Hasher().field("ab", "c").digest(), Hasher().field("a", "bc").digest());
  EXPECT_NE(Hasher().field("a", "").field("", "b").digest(), Hasher().field("a", "b").digest());
  EXPECT_EQ(Hasher().field("a", 7).digest(), Hasher().field("a", "7").digest());
}

TEST(Hash, DigestIs32HexadecimalDigits) {
  EXPECT_EQ(hash_bytes("x").find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(hash_bytes("").size(), 32u);
}

TEST(Hash, FilesHashByContent) {
  const TemporaryFolder folder;
  const std::string big(200000, 'q');
  write_file_atomic(folder.path() / "a", big);
  write_file_atomic(folder.path() / "b", big);
  write_file_atomic(folder.path() / "c", big + "r");
  EXPECT_EQ(hash_file(folder.path() / "a"), hash_file(folder.path() / "b"));
  EXPECT_NE(hash_file(folder.path() / "a"), hash_file(folder.path() / "c"));
  EXPECT_THROW(hash_file(folder.path() / "none"), Error);
}

// The keys of caches are made of these: they must stay what they are, at and beside the ends of blocks too.
TEST(Hash, FilesKeepTheirHash) {
  const TemporaryFolder folder;
  const auto expected = [](const std::string& bytes) {
    Hasher hasher;
    std::size_t start = 0;
    for (; start + (1 << 16) <= bytes.size(); start += 1 << 16)
      hasher.field("block", std::string_view(bytes).substr(start, 1 << 16));
    return hasher.field("block", std::string_view(bytes).substr(start)).digest();
  };
  for (const std::size_t size : {0, 1, 65535, 65536, 65537, 131072}) {
    const std::string bytes(size, 'q');
    write_file_atomic(folder.path() / "a", bytes);
    EXPECT_EQ(hash_file(folder.path() / "a"), expected(bytes)) << size;
  }
}

TEST(Hash, WhatWasReadHasTheHashOfTheFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a";
  write_file_atomic(file, "one");
  std::string text;
  EXPECT_EQ(hash_while_reading(file, [&] { text = read_file(file); }), hash_file(file));
  EXPECT_EQ(text, "one");
}

TEST(Hash, AFileThatChangesWhileItIsReadHasNone) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a";
  write_file_atomic(file, "one");
  EXPECT_THROW(hash_while_reading(file, [&] { write_file_atomic(file, "two"); }), Error);
  EXPECT_THROW(hash_while_reading(file,
                                  [&] {
                                    write_file_atomic(file, "three");
                                    write_file_atomic(file, "two");  // taken back: another inode all the same
                                  }),
               Error);
}

TEST(Hash, ReadingTellsItsOwnErrors) {
  const auto file = std::filesystem::path("/nowhere/a");
  EXPECT_THROW(hash_while_reading(file, [] { throw Error("no such file", "a"); }), Error);
}

}  // namespace
}  // namespace lightbench
