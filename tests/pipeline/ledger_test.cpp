#include "pipeline/ledger.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/error.h"
#include "base/files.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

LedgerEntry entry(const std::string& id, const std::string& key) {
  LedgerEntry result;
  result.id = id;
  result.key = key;
  result.key_parts = {{"view", "front"}};
  result.ended = "2020-01-01T00:00:00Z";
  result.result.seconds = 1.5;
  result.result.outputs["a.png"] = "hash";
  result.result.passes = {{"shadow map", 0.25}};
  result.result.metrics["gain"] = MetricValue::of(12.5);
  result.result.metrics["pearson"] = MetricValue::undefined("a constant image");
  return result;
}

class LedgerFile : public ::testing::Test {
 protected:
  void append_raw(const std::string& text) { std::ofstream(file_, std::ios::app) << text; }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "run" / "ledger.jsonl";
};

TEST_F(LedgerFile, KeepsWhatWasAppended) {
  Ledger(file_, LedgerUse::append).append(entry("task", "key"));
  const Ledger again(file_, LedgerUse::append);
  const LedgerEntry& kept = again.last().at("task");
  EXPECT_EQ(kept.key, "key");
  EXPECT_EQ(kept.key_parts, (KeyParts{{"view", "front"}}));
  EXPECT_EQ(kept.result.outputs.at("a.png"), "hash");
  EXPECT_EQ(kept.result.passes.at(0).name, "shadow map");
  EXPECT_EQ(kept.result.metrics.at("gain").value, 12.5);
  EXPECT_EQ(kept.result.metrics.at("pearson").undefined_because, "a constant image");
}

TEST_F(LedgerFile, TheLastEntryOfATaskCounts) {
  Ledger ledger(file_, LedgerUse::append);
  ledger.append(entry("task", "old"));
  ledger.append(entry("task", "new"));
  EXPECT_EQ(ledger.last().at("task").key, "new");
  EXPECT_EQ(ledger.last().size(), 1u);
}

TEST_F(LedgerFile, AFailureKeepsItsMessage) {
  {
    Ledger ledger(file_, LedgerUse::append);
    LedgerEntry failed = entry("task", "key");
    failed.outcome = Outcome::failed;
    failed.error = "no \"light\"\nin the scene \xff";
    ledger.append(failed);
  }
  const Ledger again(file_, LedgerUse::read);
  EXPECT_EQ(again.last().at("task").outcome, Outcome::failed);
  EXPECT_THAT(again.last().at("task").error, HasSubstr("no \"light\"\nin the scene"));
}

TEST_F(LedgerFile, ALineThatAKilledRunLeftUnfinishedIsDropped) {
  Ledger(file_, LedgerUse::append).append(entry("one", "key"));
  append_raw(R"({"v":1,"id":"tw)");
  Ledger(file_, LedgerUse::append).append(entry("two", "key"));
  const Ledger again(file_, LedgerUse::append);
  EXPECT_EQ(again.last().size(), 2u);
}

TEST_F(LedgerFile, ALineThatIsNotOursIsAnErrorWithItsNumber) {
  Ledger(file_, LedgerUse::append).append(entry("one", "key"));
  append_raw("hello\n");
  try {
    const Ledger again(file_, LedgerUse::append);
    FAIL() << "the line was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), file_.string() + ":2");
  }
}

/// Opening it is an error that has these words, and changes nothing of `file`.
void expect_refused(const std::filesystem::path& ledger, const std::filesystem::path& file,
                    const std::string& words) {
  const std::string before = read_file(file);
  try {
    const Ledger taken(ledger, LedgerUse::append);
    ADD_FAILURE() << "it was taken";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(words));
  }
  EXPECT_EQ(read_file(file), before);
}

TEST_F(LedgerFile, AFirstLineThatWasLeftUnfinishedIsDropped) {
  const std::string line = R"({"v":1,"id":"snapshot:)";
  for (std::size_t length = 0; length <= line.size(); ++length) {
    write_file_atomic(file_, line.substr(0, length));
    EXPECT_TRUE(Ledger(file_, LedgerUse::append).last().empty());
    EXPECT_EQ(read_file(file_), "");
  }
}

TEST_F(LedgerFile, AFileOfAnotherProgramIsLeftAsItIs) {
  for (const char* text :
       {"my notes", "my notes\n", "my notes\nand more", "{\"v\":1,\"name\":1", "{}", " "}) {
    write_file_atomic(file_, text);
    expect_refused(file_, file_, "remove the file");
  }
}

TEST_F(LedgerFile, ALinkIsNotFollowed) {
  Ledger(folder_.path() / "other" / "ledger.jsonl", LedgerUse::append).append(entry("task", "key"));
  std::filesystem::create_directory(file_.parent_path());
  std::filesystem::create_symlink("../other/ledger.jsonl", file_);
  expect_refused(file_, folder_.path() / "other" / "ledger.jsonl", "is a link");
  EXPECT_THROW(Ledger(file_, LedgerUse::read), Error);
}

TEST_F(LedgerFile, AFileWithASecondNameIsRefused) {
  Ledger(file_, LedgerUse::append).append(entry("task", "key"));
  std::filesystem::create_hard_link(file_, folder_.path() / "copy.jsonl");
  expect_refused(file_, file_, "second name");
  EXPECT_EQ(Ledger(file_, LedgerUse::read).last().size(), 1u);
}

TEST_F(LedgerFile, APipeOrDeviceIsRefusedAndNotWaitedFor) {
  std::filesystem::create_directory(file_.parent_path());
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  EXPECT_THROW(Ledger(file_, LedgerUse::append), Error);
  EXPECT_THROW(Ledger(file_, LedgerUse::read), Error);
  EXPECT_THROW(Ledger("/dev/null", LedgerUse::append), Error);
}

TEST_F(LedgerFile, NamesOfFilesKeepTheirBytes) {
  LedgerEntry with_bytes = entry("task", "key");
  with_bytes.key_parts = {{"file Fen\xEAtre.png", "hash"}};
  Ledger(file_, LedgerUse::append).append(with_bytes);
  EXPECT_EQ(Ledger(file_, LedgerUse::read).last().at("task").key_parts, with_bytes.key_parts);
}

TEST_F(LedgerFile, ASecondRunIsKeptOut) {
  const Ledger first(file_, LedgerUse::append);
  EXPECT_THROW(Ledger(file_, LedgerUse::append), Error);
}

TEST_F(LedgerFile, LookingIsPossibleWhileARunGoesOn) {
  Ledger first(file_, LedgerUse::append);
  first.append(entry("one", "key"));
  EXPECT_EQ(Ledger(file_, LedgerUse::read).last().size(), 1u);
}

TEST_F(LedgerFile, LookingMakesNoFile) {
  EXPECT_TRUE(Ledger(file_, LedgerUse::read).last().empty());
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(LedgerFile, AFileInPlaceOfTheFolderIsAnError) {
  write_file_atomic(folder_.path() / "run", "a file");
  EXPECT_THROW(Ledger(file_, LedgerUse::append), Error);
}

}  // namespace
}  // namespace lightbench
