// Runs and commands on a disk that is full, and goes on when it is not any more.
#include <random>

#include "base/error.h"
#include "run_fixture.h"
#include "tests/base/small_disk.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

class GlFullDisk : public test::GlRun {
 protected:
  ProcessResult run_to(const std::filesystem::path& out) const {
    return run({"run", "job.json", "--out", out.string()});
  }

  /// Pages that the files of a run take.
  static std::size_t pages(const std::filesystem::path& out) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(out))
      if (entry.is_regular_file()) count += test::SmallDisk::pages_of(entry.file_size());
    return count;
  }

  /// Every picture of the run in folder `roomy` is the same in `out`.
  static void expect_same_pictures(const std::filesystem::path& roomy, const std::filesystem::path& out) {
    std::size_t compared = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(roomy / "views")) {
      if (entry.path().extension() != ".png" && entry.path().extension() != ".exr") continue;
      const auto other = out / entry.path().lexically_relative(roomy);
      EXPECT_EQ(read_image_srgb8(other), read_image_srgb8(entry.path())) << other;
      ++compared;
    }
    EXPECT_GT(compared, 10u);
  }
};

TEST_F(GlFullDisk, ARunFailsAndIsWholeWhenTheDiskHasGrown) {
  ASSERT_EQ(run_to(path("roomy")).exit_code, 0);
  const std::size_t all = pages(path("roomy"));
  if (!test::with_small_disk([&](const test::SmallDisk& disk) {
        for (const std::size_t part : {3, 6, 9}) {
          disk.resize(all * part / 10);
          const auto full = run_to(disk.path());
          EXPECT_THAT(full.exit_code, ::testing::AnyOf(2, 3)) << part << full.out << full.err;
          EXPECT_THAT(full.out + full.err, HasSubstr("No space left on device"));
          disk.resize(4 * all);
          const auto grown = run_to(disk.path());
          EXPECT_EQ(grown.exit_code, 0) << part << grown.out << grown.err;
          expect_same_pictures(path("roomy"), disk.path());
          for (const auto& entry : std::filesystem::directory_iterator(disk.path()))
            std::filesystem::remove_all(entry.path());
        }
      }))
    GTEST_SKIP() << test::kNoMounts;
}

TEST_F(GlFullDisk, CompareKeepsTheOldDifference) {
  Image8 noise(60, 50, 3);
  std::mt19937 random(1);
  for (std::uint8_t& component : noise.data) component = std::uint8_t(random());
  write_png(path("a.png"), noise);
  write_png(path("b.png"), Image8(60, 50, 3, 9));
  if (!test::with_small_disk([&](const test::SmallDisk& disk) {
        test::expect_whole_or_old(disk, "d.png", [&](const std::filesystem::path& file) {
          const auto result = run({"compare", "a.png", "b.png", "--diff", file.string()});
          if (result.exit_code != 0) throw Error(result.err);
        });
      }))
    GTEST_SKIP() << test::kNoMounts;
}

}  // namespace
}  // namespace lightbench
