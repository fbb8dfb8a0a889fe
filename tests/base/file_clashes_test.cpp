#include "base/file_clashes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"

namespace lightbench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class FileClashes : public ::testing::Test {
 protected:
  std::string error(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs = {}) const {
    try {
      check_outputs(outputs, inputs);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

TEST_F(FileClashes, DifferentFilesAreFine) {
  write_file_atomic(path("in"), "x");
  EXPECT_EQ(
      error({{"--a", path("a")}, {"--b", path("b")}, {"--c", ""}, {"--d", ""}}, {{"the input", path("in")}}),
      "no error");
}

TEST_F(FileClashes, TwoOutputsOfOneNameAreFound) {
  EXPECT_THAT(error({{"--a", path("z")}, {"--b", path("z")}}), HasSubstr("--a and --b would be one file"));
}

TEST_F(FileClashes, SpellingDoesNotHideThem) {
  fs::create_directory(path("sub"));
  EXPECT_THAT(error({{"--a", path("z")}, {"--b", path("./sub/../z")}}), HasSubstr("one file"));
  EXPECT_THAT(error({{"--a", path("new/z")}, {"--b", path("new/./z")}}), HasSubstr("one file"));
  EXPECT_THAT(error({{"--a", "z"}, {"--b", fs::current_path() / "z"}}), HasSubstr("one file"));
}

TEST_F(FileClashes, LinksDoNotHideThem) {
  fs::create_directory(path("sub"));
  fs::create_directory_symlink(path("sub"), path("other"));
  EXPECT_THAT(error({{"--a", path("sub/z")}, {"--b", path("other/z")}}), HasSubstr("one file"));
  write_file_atomic(path("sub/in"), "x");
  fs::create_symlink(path("sub/in"), path("soft"));
  fs::create_hard_link(path("sub/in"), path("hard"));
  for (const char* link : {"soft", "hard", "other/in"})
    EXPECT_THAT(error({{"-o", path(link)}}, {{"the scene", path("sub/in")}}),
                HasSubstr("the scene would be overwritten by -o"));
}

}  // namespace
}  // namespace lightbench
