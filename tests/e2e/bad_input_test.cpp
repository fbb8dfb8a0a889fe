#include <algorithm>

#include <sys/stat.h>

#include "e2e_fixture.h"

namespace lightbench {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

/// A file that is put into the folder, the arguments, and what the message must have.
struct BadInput {
  const char* what;
  const char* file;
  std::string text;
  std::vector<std::string> arguments;
  const char* message;
};

void PrintTo(const BadInput& bad, std::ostream* stream) {
  *stream << bad.what;
}

class BadInputTo : public test::Program, public ::testing::WithParamInterface<BadInput> {};

TEST_P(BadInputTo, IsOneClearMessageAndLeavesNothing) {
  if (*GetParam().file) write(GetParam().file, GetParam().text);
  const auto before = files();
  const auto result = run(GetParam().arguments);
  EXPECT_EQ(result.exit_code, 3) << result.out << result.err;
  EXPECT_THAT(result.err, HasSubstr(GetParam().message));
  EXPECT_THAT(result.err, HasSubstr("lightbench: error: "));
  EXPECT_EQ(files(), before);
}

std::vector<std::string> render(std::vector<std::string> more = {"--position", "0", "0", "4", "--look-at",
                                                                 "0", "0", "0"}) {
  std::vector<std::string> arguments = {"render", "scene.json", "--size", "16x12", "-o", "out.png"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

const BadInput kBadInputs[] = {
    {"missing scene", "", "", {"render", "nowhere.json"}, "nowhere.json"},
    {"scene of another kind", "", "", {"render", "cameras.txt"}, "cameras.txt: a scene is"},
    {"truncated scene", "scene.json", R"({"entities": [{"obj": "box)", render(), "scene.json:1"},
    {"missing OBJ", "scene.json", R"({"entities": [{"obj": "nowhere.obj"}]})", render(),
     "scene.json: $.entities[0].obj: there is no file"},
    {"truncated OBJ", "box.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 ", render(), "box.obj:4"},
    {"empty OBJ", "box.obj", "", render(), "box.obj"},
    {"NaN vertex", "box.obj", "v 0 0 0\nv nan 0 0\nv 1 1 0\nf 1 2 3\n", render(), "box.obj:2"},
    {"index out of range", "box.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n", render(), "box.obj:4"},
    {"missing MTL", "box.obj", "mtllib nowhere.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", render(),
     "nowhere.mtl"},
    {"truncated MTL", "box.mtl", "newmtl grey\nKd 0.6 0", render(), "box.mtl:2"},
    {"missing texture", "box.mtl", "newmtl grey\nmap_Kd nowhere.png\n", render(), "nowhere.png"},
    {"truncated texture", "box.mtl", "newmtl grey\nmap_Kd box.obj\n", render(), "box.obj"},
    {"missing camera script", "", "", render({"--cameras", "nowhere.json"}), "nowhere.json"},
    {"truncated camera script", "cameras.json", R"({"views": [)", render({"--cameras", "cameras.json"}),
     "cameras.json:1"},
    {"zero-area camera in a script", "cameras.json",
     R"({"views": [{"name": "a", "position": [1, 1, 1], "look_at": [1, 1, 1]}]})",
     render({"--cameras", "cameras.json"}), "cameras.json: $.views[0]"},
    {"camera without a field of view", "cameras.json",
     R"({"views": [{"name": "a", "position": [1, 1, 1], "look_at": [0, 0, 0], "fov": 0}]})",
     render({"--cameras", "cameras.json"}), "$.views[0].fov"},
    {"zero-area camera", "", "", render({"--position", "1", "1", "1", "--look-at", "1", "1", "1"}),
     "--position"},
    {"unknown view", "", "", render({"--cameras", "cameras.json", "--view", "frnot"}),
     "did you mean 'front'?"},
    {"zero-size image", "", "", {"render", "scene.json", "--size", "0x12"}, "--size"},
    {"image of 100k x 100k", "", "", {"render", "scene.json", "--size", "100000x100000"}, "--size"},
    {"size that is none",
     "",
     "",
     {"render", "scene.json", "--size", "large"},
     "--size: must be WIDTHxHEIGHT"},
    {"unknown technique", "", "", {"render", "scene.json", "-t", "dierct"}, "did you mean 'direct'?"},
    {"unknown parameter", "", "", {"render", "scene.json", "-p", "shadow=hard"}, "did you mean 'shadows'?"},
    {"parameter out of range", "", "", {"render", "scene.json", "-p", "pcf_radius=-1"}, "--param pcf_radius"},
    {"output of another kind", "", "", {"render", "scene.json", "-o", "out.jpg"}, "must end in .png or .exr"},
    {"missing picture", "", "", {"compare", "nowhere.png", "nowhere.png"}, "nowhere.png"},
    {"truncated EXR",
     "a.exr",
     std::string("\x76\x2f\x31\x01\x02\0\0\0", 8),
     {"compare", "a.exr", "a.exr"},
     "a.exr"},
    {"truncated PNG", "a.png", "\x89PNG\r\n\x1a\n", {"compare", "a.png", "a.png"}, "a.png"},
    {"missing job", "", "", {"run", "nowhere.json"}, "nowhere.json"},
    {"truncated job", "job.json", R"({"scenes": [)", {"run", "job.json"}, "job.json:1"},
    {"empty job", "job.json", "{}", {"run", "job.json"}, "$: the key 'scenes' is missing"},
    {"job with a missing camera script",
     "job.json",
     R"({"scenes": [{"scene": "scene.json", "cameras": "c.json"}], "variants": [{"technique": "direct"}]})",
     {"plan", "job.json"},
     "c.json"},
    {"report of no run", "", "", {"report", "."}, "run.json"},
    {"report of a broken run", "run.json", "{}", {"report", "."}, "run.json"},
    {"score of no run", "", "", {"score", "."}, "plan.json"},
};
INSTANTIATE_TEST_SUITE_P(All, BadInputTo, ::testing::ValuesIn(kBadInputs));

/// A number option of each command that has one, without its value.
const std::vector<std::vector<std::string>> kNumberOptions = {
    {"render", "scene.json", "--fov"},
    {"render", "scene.json", "--time"},
    {"render", "scene.json", "--samples"},
    {"render", "scene.json", "--look-at", "0", "0", "0", "--position", "0", "0"},
    {"render", "scene.json", "--position", "0", "0", "4", "--look-at", "0", "0"},
    {"render", "scene.json", "--position", "0", "0", "4", "--look-at", "0", "0", "0", "--up", "0", "0"},
    {"reference", "scene.json", "-o", "out.png", "--timeout"},
    {"compare", "a.png", "a.png", "--heat-scale"},
    {"cameras", "scene.json", "--fov"},
    {"cameras", "scene.json", "--random"},
    {"cameras", "scene.json", "--seed"},
    {"cameras", "scene.json", "--generator"},
    {"bake", "scene.json", "--threads"},
    {"bench", "job.json", "--rounds"},
    {"run", "job.json", "-j"},
    {"caustics", "scene.json", "--rays"},
    {"caustics", "scene.json", "--map-size"},
    {"caustics", "scene.json", "--slices"},
    {"caustics", "scene.json", "--most"},
    {"caustics", "scene.json", "--amplitudes"},
    {"caustics", "scene.json", "--photon-spacing"},
    {"slicing", "scene.json", "-o", "slicing", "--rounds"},
    {"slicing", "scene.json", "-o", "slicing", "--map-size"},
    {"slicing", "scene.json", "-o", "slicing", "--planes"},
};

class NumberOption : public test::Program, public ::testing::WithParamInterface<std::vector<std::string>> {};

TEST_P(NumberOption, TakesFiniteNumbersOnly) {
  const auto before = files();
  const auto is_option = [](const std::string& word) { return word.size() > 1 && word[0] == '-'; };
  const std::string option = *std::find_if(GetParam().rbegin(), GetParam().rend(), is_option);
  for (const char* value : {"nan", "inf", "-inf", "1e999", "3x", "0x1", " 1", "1 ", "+-1"}) {
    auto arguments = GetParam();
    arguments.emplace_back(value);
    const auto result = run(arguments);
    EXPECT_EQ(result.exit_code, 3) << value << ": " << result.out << result.err;
    // Behind two numbers of three, a word with a minus that is no number is taken for an option.
    EXPECT_THAT(result.out + result.err, AnyOf(HasSubstr(option), HasSubstr("there is no option '-inf'")))
        << value;
  }
  EXPECT_EQ(files(), before);
}
INSTANTIATE_TEST_SUITE_P(All, NumberOption, ::testing::ValuesIn(kNumberOptions));

TEST_F(BadInputTo, AParameterThatIsNotFiniteIsAnError) {
  for (const char* value : {"nan", "inf", "-nan"}) {
    const auto result = run({"render", "scene.json", "-t", "ambient", "-p", std::string("k=") + value});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr("--param k: 'k' must be between"));
  }
}

/// What has no end, in the place of each file that a command reads.
class Endless : public test::Program {
 protected:
  void expect_refused(const std::string& file, const std::vector<std::string>& arguments) {
    std::filesystem::remove(path(file));
    ASSERT_EQ(::mkfifo(path(file).c_str(), 0600), 0);
    expect_error(file, arguments, "is not a regular file (a FIFO)");
    std::filesystem::remove(path(file));
    std::filesystem::create_symlink("/dev/zero", path(file));
    expect_error(file, arguments, "is not a regular file (a device)");
    std::filesystem::remove(path(file));
    write(file, "");
    std::filesystem::resize_file(path(file), 1'000'000'000'000);
    expect_error(file, arguments, "has 1 TB, and at most");
    std::filesystem::remove(path(file));
  }

 private:
  void expect_error(const std::string& file, const std::vector<std::string>& arguments, const char* what) {
    const auto result = run(arguments);
    EXPECT_EQ(result.exit_code, 3) << file << result.out << result.err;
    EXPECT_THAT(result.err, ::testing::AllOf(HasSubstr(file), HasSubstr(what)));
  }
};

TEST_F(Endless, FilesAreRefusedWhereverOneIsNamed) {
  const std::string job = R"({"scenes": [{"scene": "scene.json", "cameras": "cameras.json"}],
                              "variants": [{"technique": "direct"}]})";
  write("job.json", job);
  expect_refused("cameras.json", {"plan", "job.json"});
  expect_refused("job.json", {"plan", "job.json"});
  expect_refused("box.obj", render({}));
  expect_refused("scene.json", render({}));
  expect_refused("run.json", {"report", "."});
  expect_refused("plan.json", {"score", "."});
  expect_refused("plan.json", {"work", "plan.json", "snapshot:a"});
}

TEST_F(Endless, APictureOfAnotherEngineDoesNotStopThePlanning) {
  write("job.json", R"({"scenes": [{"scene": "scene.json", "cameras": "cameras.json"}],
                        "variants": [{"technique": "images", "params": {"pattern": "{view}.png"}}]})");
  ASSERT_EQ(::mkfifo(path("front.png").c_str(), 0600), 0);
  const auto result = run({"plan", "job.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

class BadOutput : public test::Program {};

TEST_F(BadOutput, OfRandomViewsIsAnError) {
  write("taken", "a file");
  const auto result = run({"cameras", "scene.json", "-o", "taken/cameras.json"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("taken"));
}

TEST_F(BadOutput, OfARunIsAnErrorBeforeAnyWork) {
  write("job.json", R"({"scenes": [{"scene": "scene.json", "cameras": "cameras.json"}],
                        "variants": [{"technique": "direct"}]})");
  write("taken", "a file");
  for (const char* out : {"taken", "taken/below", "/proc/lightbench", "/dev/null/out"}) {
    const auto result = run({"run", "job.json", "--out", out});
    EXPECT_EQ(result.exit_code, 3) << out;
    EXPECT_THAT(result.err, HasSubstr(out));
  }
}

TEST_F(BadOutput, OfAnExportIsAnError) {
  const auto result = run({"export", "scene.json", "--cameras", "cameras.json", "-o", "/proc/lightbench"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("/proc/lightbench"));
}

TEST_F(BadOutput, OfAReferenceIsAnErrorBeforeItIsRendered) {
  fake_povray("touch '" + path("rendered").string() + "'");
  const auto result =
      run({"reference", "scene.json", "--cameras", "cameras.json", "-o", "/proc/lightbench/a.exr"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("/proc/lightbench"));
  EXPECT_FALSE(std::filesystem::exists(path("rendered")));
}

TEST_F(BadOutput, WithoutPovrayAReferenceSaysWhatIsMissing) {
  environment_["LIGHTBENCH_POVRAY"] = "";
  environment_["PATH"] = "/nowhere";
  const auto before = files();
  const auto result = run({"reference", "scene.json", "--cameras", "cameras.json"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("POV-Ray is not there"));
  EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace lightbench
