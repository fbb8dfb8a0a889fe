#include <limits>

#include "e2e_fixture.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

class Cli : public test::Program {};

TEST_F(Cli, WithoutACommandItSaysWhatThereIs) {
  const auto result = run({});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err + result.out, HasSubstr("--help"));
}

TEST_F(Cli, AnUnknownCommandNamesTheNearest) {
  const auto result = run({"rnu", "job.json"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("there is no command 'rnu' (did you mean 'run'?)"));
}

TEST_F(Cli, AnUnknownOptionIsAnError) {
  EXPECT_EQ(run({"list", "--verbose"}).exit_code, 3);
}

TEST_F(Cli, HelpExplainsWithExamplesAndExitCodes) {
  const auto result = run({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("lightbench run jobs/cornell.json"));
  EXPECT_THAT(result.out, HasSubstr("Exit codes: 0"));
}

class CliHelp : public Cli, public ::testing::WithParamInterface<std::vector<std::string>> {};

TEST_P(CliHelp, OfEveryCommandHasAnExample) {
  auto arguments = GetParam();
  arguments.push_back("--help");
  const auto result = run(arguments);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, ::testing::AnyOf(HasSubstr("Example"), HasSubstr("default: all")));
}

INSTANTIATE_TEST_SUITE_P(
    Commands, CliHelp,
    ::testing::Values(std::vector<std::string>{"run"}, std::vector<std::string>{"oracle"},
                      std::vector<std::string>{"plan"}, std::vector<std::string>{"score"},
                      std::vector<std::string>{"report"}, std::vector<std::string>{"bench"},
                      std::vector<std::string>{"render"}, std::vector<std::string>{"export"},
                      std::vector<std::string>{"reference"}, std::vector<std::string>{"compare"},
                      std::vector<std::string>{"cameras"}, std::vector<std::string>{"caustics"},
                      std::vector<std::string>{"scene", "check"}, std::vector<std::string>{"list"},
                      std::vector<std::string>{"schema"}));

TEST_F(Cli, TheVersionNamesTheTools) {
  fake_povray("");
  const auto result = run({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("lightbench "));
  EXPECT_THAT(result.out, HasSubstr("POV-Ray 3.7.fake"));
}

TEST_F(Cli, ListsReadTheTables) {
  EXPECT_THAT(run({"list", "metrics"}).out, HasSubstr("mean_error"));
  EXPECT_THAT(run({"list", "techniques"}).out, HasSubstr("direct"));
  EXPECT_THAT(run({"list", "references"}).out, HasSubstr("povray"));
  EXPECT_THAT(run({"list", "formats"}).out, HasSubstr("junit"));
  EXPECT_THAT(run({"list", "params"}).out, HasSubstr("brightness"));
  EXPECT_EQ(run({"list", "metrix"}).exit_code, 3);
}

TEST_F(Cli, OutputThatCannotBeWrittenIsAnError) {
  const auto result =
      run_process({.argv = {"sh", "-c", std::string(LIGHTBENCH_BINARY) + " list > /dev/full"}});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("cannot be written"));
}

TEST_F(Cli, NamesCannotSteerATerminal) {
  const std::string name = "no\x1b[31m\u202E\xff.obj";
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", name}, {name}, {"list", "--" + name}, {"scene", "check", name}}) {
    const auto result = run(arguments);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.out + result.err, HasSubstr("no\uFFFD[31m\uFFFD\uFFFD.obj"));
    EXPECT_THAT(result.out + result.err, ::testing::Not(HasSubstr("\x1b")));
  }
}

TEST_F(Cli, RandomViewsAreTheSameForTheSameSeed) {
  const auto first = run({"cameras", "scene.json", "--random", "3", "--seed", "7"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(run({"cameras", "scene.json", "--random", "3", "--seed", "7"}).out, first.out);
  EXPECT_NE(run({"cameras", "scene.json", "--random", "3", "--seed", "8"}).out, first.out);
}

TEST_F(Cli, SceneCheckListsAllScenesAndSaysWhichCannotBeUsed) {
  write("broken.json", R"({"entities": [{"obj": "nowhere.obj"}], "light": []})");
  const auto result = run({"scene", "check", "broken.json", "scene.json"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out, HasSubstr("$.entities[0].obj"));
  EXPECT_THAT(result.out, HasSubstr("did you mean 'lights'?"));
  EXPECT_THAT(result.out, HasSubstr("scene.json: fine: 12 triangles"));
}

TEST_F(Cli, ComparePrintsMetricsAndDrawsDifferences) {
  write_png(path("a.png"), Image8(4, 3, 3, 10));
  write_png(path("b.png"), Image8(4, 3, 3, 30));
  const auto result =
      run({"compare", "a.png", "b.png", "--metric", "mean_error", "--diff", "d.png", "--heat", "h.png"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("20.000 of 255"));
  EXPECT_THAT(result.out, HasSubstr("largest error 20 of 255 at x 0, y 0"));
  EXPECT_EQ(read_image_srgb8(path("d.png")).data[0], 235);  // 255 - 20
  EXPECT_TRUE(std::filesystem::exists(path("h.png")));
}

TEST_F(Cli, CompareRefusesOtherSizes) {
  write_png(path("a.png"), Image8(4, 3, 3, 10));
  write_png(path("b.png"), Image8(3, 4, 3, 10));
  const auto result = run({"compare", "a.png", "b.png", "--diff", "d.png"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("4x3"));
  EXPECT_FALSE(std::filesystem::exists(path("d.png")));
}

TEST_F(Cli, CompareNeverOverwritesWhatItCompares) {
  write_png(path("a.png"), Image8(4, 3, 3, 10));
  write_png(path("b.png"), Image8(4, 3, 3, 30));
  const auto result = run({"compare", "a.png", "b.png", "--diff", "a.png"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("would be overwritten"));
  EXPECT_EQ(read_image_srgb8(path("a.png")).data[0], 10);
}

TEST_F(Cli, OutputsNeverReplaceWhatTheyAreMadeFrom) {
  const std::string scene = read_file(path("scene.json")), object = read_file(path("box.obj"));
  write("tex_0001.png", encode_png(Image8(4, 4, 3, 128)));
  write("box.mtl", "newmtl grey\nKd 1 1 1\nmap_Kd tex_0001.png\n");
  const std::string texture = read_file(path("tex_0001.png"));
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"cameras", "scene.json", "-o", "scene.json"},
        {"cameras", "scene.json", "-o", "./box.obj"},
        {"bench", "job.json", "-o", "scene.json"},
        {"caustics", "scene.json", "-o", "scene.json"},
        {"export", "scene.json", "--cameras", "cameras.json", "-o", "."}}) {
    write("job.json", R"({"scenes": [{"scene": "scene.json", "cameras": "cameras.json"}],
                          "variants": [{"name": "direct", "technique": "direct"}]})");
    const auto result = run(command);
    EXPECT_EQ(result.exit_code, 3) << command.front();
    EXPECT_THAT(result.err, HasSubstr("would be overwritten by")) << command.front();
  }
  EXPECT_EQ(read_file(path("scene.json")), scene);
  EXPECT_EQ(read_file(path("box.obj")), object);
  EXPECT_EQ(read_file(path("tex_0001.png")), texture);
}

TEST_F(Cli, CompareRefusesWhatIsNoNumber) {
  Image image(2, 2, 3, 0.5f);
  image.data[4] = std::numeric_limits<float>::quiet_NaN();
  write_exr(path("a.exr"), image, PixelType::half);
  write_png(path("b.png"), Image8(2, 2, 3, 10));
  const auto result = run({"compare", "b.png", "a.exr"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("a.exr"));
}

TEST_F(Cli, ThePathTracerHasNothingToExport) {
  const auto result = run({"export", "scene.json", "--cameras", "cameras.json", "--kind", "path_tracer"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("nothing to export"));
}

TEST_F(Cli, ExportWritesEveryViewOnceAndWhatTheyShare) {
  EXPECT_EQ(run({"export", "scene.json", "--cameras", "cameras.json", "-o", "pov"}).exit_code, 0);
  EXPECT_TRUE(files("pov").contains("pov/front.pov"));
  EXPECT_TRUE(files("pov").contains("pov/side.pov"));
}

}  // namespace
}  // namespace lightbench
