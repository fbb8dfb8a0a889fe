#include <algorithm>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "base/files.h"
#include "fuzz_targets.h"

/// Gives each fuzzed reader the files of its corpus: small valid ones, and one for each fault that was found.
namespace lightbench::fuzz {
/// Names the target where GoogleTest prints a parameter.
void PrintTo(const FuzzTarget& target, std::ostream* stream) {
  *stream << target.name;
}

namespace {

const std::filesystem::path kCorpus = LIGHTBENCH_SOURCE_DIR "/tests/fuzz/corpus";

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

bool is_valid(const std::filesystem::path& file) {
  return file.filename().string().starts_with("valid");
}

class Corpus : public ::testing::TestWithParam<FuzzTarget> {};

TEST_P(Corpus, IsReadOrRefused) {
  for (const auto& file : files_in(kCorpus / GetParam().name)) {
    SCOPED_TRACE(file.string());
    const std::string bytes = read_file(file);
    if (is_valid(file))
      EXPECT_NO_THROW(GetParam().read(bytes));
    else
      EXPECT_NO_THROW(is_read(GetParam(), bytes));
  }
}

// Without a valid file a fuzzer does not come far, and without a refused one nothing shows that readers
// refuse.
TEST_P(Corpus, HasFilesThatAreReadAndOthers) {
  const auto files = files_in(kCorpus / GetParam().name);
  EXPECT_TRUE(std::ranges::any_of(files, is_valid));
  EXPECT_TRUE(
      std::ranges::any_of(files, [](const auto& file) { return !is_read(GetParam(), read_file(file)); }));
}

INSTANTIATE_TEST_SUITE_P(All, Corpus, ::testing::ValuesIn(fuzz_targets().begin(), fuzz_targets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

TEST(FuzzTargets, HaveEachACorpusAndNoCorpusIsLeftOver) {
  std::vector<std::string> folders, names;
  for (const auto& folder : files_in(kCorpus)) folders.push_back(folder.filename().string());
  for (const FuzzTarget& target : fuzz_targets()) names.emplace_back(target.name);
  EXPECT_EQ(folders, names);
}

}  // namespace
}  // namespace lightbench::fuzz
