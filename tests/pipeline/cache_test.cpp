#include "pipeline/cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/hash.h"
#include "job_fixture.h"

namespace lightbench {
namespace {

class CacheOfAFolder : public ::testing::Test {
 protected:
  CacheOfAFolder() {
    task_.id = "snapshot:a/b/c";
    task_.key_parts = {{"view", "front"}, {"size", "8x6"}};
    task_.key = key_of(task_.key_parts);
    task_.outputs = {"picture.png"};
    write_file_atomic(out_.path() / "picture.png", "pixels");
    LedgerEntry entry;
    entry.id = task_.id;
    entry.key = task_.key;
    entry.key_parts = task_.key_parts;
    entry.result.seconds = 3;
    entry.result.outputs["picture.png"] = hash_file(out_.path() / "picture.png");
    cache_.record(entry);
  }

  TemporaryFolder out_;
  Ledger ledger_{out_.path() / "ledger.jsonl", LedgerUse::append};
  FolderCache cache_{ledger_, out_.path()};
  Task task_;
};

TEST_F(CacheOfAFolder, FindsWhatIsThere) {
  EXPECT_TRUE(cache_.find(task_).has_value());
}

TEST_F(CacheOfAFolder, AnotherKeyIsNotFound) {
  task_.key_parts[0].second = "back";
  task_.key = key_of(task_.key_parts);
  EXPECT_FALSE(cache_.find(task_).has_value());
  EXPECT_EQ(cache_.why_missing(task_), "changed: view");
}

TEST_F(CacheOfAFolder, AChangedFileIsNotFound) {
  write_file_atomic(out_.path() / "picture.png", "other pixels");
  EXPECT_FALSE(cache_.find(task_).has_value());
  EXPECT_EQ(cache_.why_missing(task_), "picture.png was changed");
}

TEST_F(CacheOfAFolder, AMissingFileIsNotFound) {
  std::filesystem::remove(out_.path() / "picture.png");
  EXPECT_FALSE(cache_.find(task_).has_value());
  EXPECT_EQ(cache_.why_missing(task_), "picture.png is missing");
}

TEST_F(CacheOfAFolder, AnOutputThatWasNotAskedForBeforeIsMissing) {
  task_.outputs.push_back("albedo.png");
  EXPECT_FALSE(cache_.find(task_).has_value());
  EXPECT_EQ(cache_.why_missing(task_), "albedo.png was not made");
}

TEST_F(CacheOfAFolder, AFailureIsTriedAgain) {
  LedgerEntry failed;
  failed.id = task_.id;
  failed.key = "another";
  failed.outcome = Outcome::failed;
  cache_.record(failed);
  task_.key = failed.key;
  EXPECT_FALSE(cache_.find(task_).has_value());
  EXPECT_EQ(cache_.why_missing(task_), "failed the last time");
}

TEST_F(CacheOfAFolder, AFailureDoesNotHideWhatWasDoneBefore) {
  LedgerEntry failed;
  failed.id = task_.id;
  failed.key = "a scene that could not be read";
  failed.outcome = Outcome::failed;
  cache_.record(failed);
  EXPECT_TRUE(cache_.find(task_).has_value());
  EXPECT_EQ(cache_.last_seconds(task_), 3.0);
  std::filesystem::remove(out_.path() / "picture.png");
  EXPECT_FALSE(cache_.find(task_).has_value());
}

TEST_F(CacheOfAFolder, TheLastTimeIsRememberedWhateverTheKey) {
  task_.key = "another";
  EXPECT_EQ(cache_.last_seconds(task_), 3.0);
  task_.id = "snapshot:x/y/z";
  EXPECT_EQ(cache_.last_seconds(task_), std::nullopt);
}

TEST(ChangedParts, AreNamed) {
  EXPECT_EQ(changed_parts({{"a", "1"}, {"b", "2"}, {"c", "3"}}, {{"a", "1"}, {"b", "3"}, {"d", "4"}}),
            "b, d (new), c (gone)");
}

}  // namespace
}  // namespace lightbench
