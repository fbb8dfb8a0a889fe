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

}  // namespace
}  // namespace lightbench
