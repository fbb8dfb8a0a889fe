#include "e2e_fixture.h"

namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

struct BadUsage {
  const char* name;
  std::vector<std::string> arguments;
  const char* message;
};

void PrintTo(const BadUsage& usage, std::ostream* out) {
  *out << usage.name;
}

class Usage : public test::Program, public ::testing::WithParamInterface<BadUsage> {};

TEST_P(Usage, MistakesNameTheNearest) {
  const auto before = files();
  const auto result = run(GetParam().arguments);
  EXPECT_EQ(result.exit_code, 3) << result.out;
  EXPECT_THAT(result.err + result.out, HasSubstr(GetParam().message));
  EXPECT_EQ(files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    All, Usage,
    ::testing::Values(
        BadUsage{"command",
                 {"comprae", "a.png", "b.png"},
                 "there is no command 'comprae' (did you mean 'compare'?)"},
        BadUsage{"command of a command",
                 {"scene", "chekc", "scene.json"},
                 "(did you mean 'check'?); see lightbench scene --help"},
        BadUsage{"option",
                 {"run", "job.json", "--jbos", "4"},
                 "there is no option '--jbos' (did you mean '--jobs'?)"},
        BadUsage{"option with its value",
                 {"run", "job.json", "--jbos=4"},
                 "there is no option '--jbos' (did you mean '--jobs'?)"},
        BadUsage{
            "option where the job is missing", {"run", "--retry-faild"}, "(did you mean '--retry-failed'?)"},
        BadUsage{"option of a command of a command",
                 {"scene", "check", "--hepl", "scene.json"},
                 "see lightbench scene check --help"},
        BadUsage{"word too many", {"plan", "a.json", "b.json"}, "'b.json' is one word too many"},
        BadUsage{"stage",
                 {"run", "job.json", "--stages", "snapshoot"},
                 "not 'snapshoot' (did you mean 'snapshot'?)"},
        BadUsage{"format", {"report", ".", "--format", "htlm"}, "not 'htlm' (did you mean 'html'?)"},
        BadUsage{"list", {"list", "metrix"}, "not 'metrix' (did you mean 'metrics'?)"},
        BadUsage{"technique of a list",
                 {"list", "params", "irs"},
                 "no technique or reference is called 'irs' (did you mean 'isr'?)"},
        BadUsage{
            "name of a list without parameters", {"list", "metrics", "isr"}, "only 'params' takes the name"},
        BadUsage{"metric", {"compare", "a.png", "b.png", "-m", "ssim"}, "there are: mean_error, pearson"},
        BadUsage{"parameter given twice",
                 {"render", "scene.json", "-p", "shadows=hard", "-p", "shadows=esm"},
                 "'shadows' is given twice"},
        BadUsage{"hexadecimal seed",
                 {"cameras", "scene.json", "--seed", "0x1"},
                 "--seed: must be a number between 0 and"}));

TEST_F(Usage, ListsTheParametersOfOneTechnique) {
  const auto result = run({"list", "params", "isr"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("isr\n"), HasSubstr("samples"), Not(HasSubstr("brightness"))));
}

TEST_F(Usage, ListsTheParametersOfOneReference) {
  EXPECT_THAT(run({"list", "params", "povray"}).out, AllOf(HasSubstr("brightness"), Not(HasSubstr("isr\n"))));
}

TEST_F(Usage, ANumberWithZerosInFrontIsNotReadAsOctal) {
  const auto result = run({"cameras", "scene.json", "--random", "010"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out + result.err, HasSubstr("--random: write the number without zeros in front"));
}

TEST_F(Usage, CamerasCountsOneViewAsOne) {
  EXPECT_THAT(run({"cameras", "scene.json", "-o", "c.json"}).out, HasSubstr("c.json: 1 view\n"));
}

}  // namespace
}  // namespace lightbench
