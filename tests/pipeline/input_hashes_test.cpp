#include "pipeline/input_hashes.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "base/hash.h"

namespace lightbench {
namespace {

TEST(InputHashes, FollowTheFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.exr";
  InputHashes hashes;
  write_file_atomic(file, "one");
  EXPECT_EQ(hashes.hash(file), hash_file(file));
  write_file_atomic(file, "two");  // another inode
  EXPECT_EQ(hashes.hash(file), hash_file(file));
  EXPECT_EQ(hashes.hash(file), hash_file(file)) << "from memory";
}

TEST(InputHashes, AMissingFileIsAnError) {
  const TemporaryFolder folder;
  EXPECT_THROW(InputHashes().hash(folder.path() / "nowhere"), Error);
}

}  // namespace
}  // namespace lightbench
