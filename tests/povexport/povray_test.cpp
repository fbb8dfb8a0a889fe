#include "povexport/povray.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "base/error.h"
#include "pov_test_scenes.h"

namespace lightbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A program that stands in for povray.
class FakePovray {
 public:
  explicit FakePovray(const std::string& script) {
    write_file_atomic(file(), "#!/bin/sh\n" + script);
    chmod(file().c_str(), 0755);
    write_file_atomic(folder_.path() / "view.pov", "");
  }

  PovrayRun run() const {
    PovrayRun run;
    run.program = file();
    run.scene_file = folder_.path() / "view.pov";
    run.library = folder_.path();
    run.width = run.height = 2;
    return run;
  }

  std::string error() const {
    try {
      run_povray(run());
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  std::filesystem::path file() const { return folder_.path() / "povray"; }

 private:
  TemporaryFolder folder_;
};

TEST(FakePovray, NoImageIsItsOwnFailure) {
  EXPECT_THAT(FakePovray("exit 0").error(), AllOf(HasSubstr("view.pov"), HasSubstr("no image")));
}

TEST(FakePovray, AnExitCodeIsToldWithTheLastWords) {
  EXPECT_THAT(FakePovray("echo first >&2; echo 'out of paint' >&2; exit 3").error(),
              AllOf(HasSubstr("exit code 3"), HasSubstr("out of paint")));
}

TEST(FakePovray, AParseErrorIsToldWithItsLine) {
  const std::string script = "echo \"File 'scene.inc' line 12: Parse Error: No matching }.\" >&2; exit 1";
  EXPECT_THAT(FakePovray(script).error(), HasSubstr("scene.inc:12: Parse Error: No matching }."));
}

TEST(FakePovray, ATimeoutEndsOneThatIgnoresTerm) {
  const FakePovray fake("trap '' TERM; while :; do sleep 0.05; done");
  PovrayRun run = fake.run();
  run.timeout = std::chrono::milliseconds(100);
  EXPECT_THROW(run_povray(run), Error);
}

TEST(FakePovray, OneThatWaitsForEverIsEnded) {
  const FakePovray fake("kill -STOP $$");
  PovrayRun run = fake.run();
  run.idle_timeout = std::chrono::milliseconds(200);
  try {
    run_povray(run);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("povray stalled"));
  }
}

TEST(FakePovray, AWrongSizeIsAFailure) {
  const TemporaryFolder folder;
  write_exr(folder.path() / "wrong.exr", Image(3, 2, 4, 0.5f), PixelType::half);
  const FakePovray fake("cp " + (folder.path() / "wrong.exr").string() + " image.exr");
  EXPECT_THAT(fake.error(), HasSubstr("another size"));
}

TEST(FakePovray, NanIsAFailureThatNamesThePixel) {
  const TemporaryFolder folder;
  Image image(2, 2, 4, 0.5f);
  image.pixel(1, 0)[2] = NAN;
  write_exr(folder.path() / "nan.exr", image, PixelType::half);
  const FakePovray fake("cp " + (folder.path() / "nan.exr").string() + " image.exr");
  EXPECT_THAT(fake.error(), HasSubstr("pixel 1, 0"));
}

TEST(FakePovray, WhatIsTooBrightForHalvesIsClampedWithAWarning) {
  const TemporaryFolder folder;
  Image image(2, 2, 4, 0.5f);
  image.pixel(1, 0)[2] = INFINITY;
  write_exr(folder.path() / "bright.exr", image, PixelType::half);
  const FakePovray fake("cp " + (folder.path() / "bright.exr").string() + " image.exr");
  const PovrayImage made = run_povray(fake.run());
  EXPECT_EQ(made.image.pixel(1, 0)[2], kLargestHalf);
  ASSERT_EQ(made.warnings.size(), 1u);
  EXPECT_THAT(made.warnings.front(), HasSubstr("1 of 16 numbers"));
}

TEST(FakePovray, UserSettingsTakeNoPart) {
  const FakePovray fake(
      "[ \"$POVINI\" = \"$HOME/empty.ini\" ] && [ \"$HOME\" = \"$PWD\" ] && echo alone >&2; exit 1");
  EXPECT_THAT(fake.error(), HasSubstr("alone"));
}

TEST(FakePovray, PathsWithOddCharactersArrive) {
  const TemporaryFolder folder("li ght'b\"ench");
  const FakePovray fake("cat scene.pov >&2; ls library >&2; exit 1");
  PovrayRun run = fake.run();
  run.scene_file = folder.path() / "a b;c.pov";
  run.library = folder.path();
  write_file_atomic(run.scene_file, "the scene");
  try {
    run_povray(run);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("the scene"), HasSubstr("a b;c.pov")));
  }
}

TEST(FakePovray, TheVersionIsRead) {
  const FakePovray fake("echo 'POV-Ray 3.7.0.10.unofficial' >&2");
  EXPECT_EQ(povray_version(fake.file()), "3.7.0.10.unofficial");
}

TEST(FakePovray, AnAnswerOfOneLongLineIsNoTrouble) {
  const std::string long_line = "head -c 10000000 /dev/zero | tr '\\0' x";
  const FakePovray never_ends("printf 'POV-Ray 3'; " + long_line);
  EXPECT_THROW(povray_version(never_ends.file()), Error);
  const FakePovray says_it_at_last(long_line + "; echo; echo 'POV-Ray 3.7.0'");
  EXPECT_EQ(povray_version(says_it_at_last.file()), "3.7.0");
  const FakePovray fails(long_line + " >&2; exit 1");
  EXPECT_LE(fails.error().size(), 2000u);
}

TEST(FakePovray, AnotherProgramIsNotPovray) {
  EXPECT_THROW(povray_version(FakePovray("echo hello").file()), Error);
}

TEST(FindPovray, SaysHowToInstallIt) {
  setenv("LIGHTBENCH_POVRAY", "/nowhere/povray", 1);
  try {
    find_povray();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("apt-get install povray"));
  }
  unsetenv("LIGHTBENCH_POVRAY");
}

TEST(PovrayArguments, HoldNoPaths) {
  PovrayRun run;
  run.scene_file = "/a/b.pov";
  for (const std::string& argument : povray_arguments(run)) EXPECT_EQ(argument.find('/'), std::string::npos);
}

TEST(PovrayRunner, AMissingBraceIsToldWithItsLine) {
  try {
    render_text("#version 3.7;\nsphere{0,1\n", {}, {}, 4, 4);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("scene.pov:"));
  }
}

TEST(PovrayRunner, AnEmptySceneIsAFailure) {
  EXPECT_THROW(render_text("#version 3.7;\nglobal_settings{assumed_gamma 1}\n", {}, {}, 4, 4), Error);
}

TEST(PovrayRunner, AMissingIncludeIsToldByName) {
  try {
    render_text("#version 3.7;\n#include \"absent.inc\"\n", {}, {}, 4, 4);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("absent.inc"));
  }
}

TEST(PovrayRunner, RadiosityIsTheSameToTheBitInTwoRuns) {
  Scene scene = scene_of(facing_square());
  scene.meshes.push_back(quad_mesh({{-1, -1, 0}, {-1, -1, 1}, {-1, 1, 1}, {-1, 1, 0}}));
  scene.entities.push_back({"wall", 1, glm::mat4(1)});
  scene.lights = {frontal_light()};
  EXPECT_EQ(render(scene, facing_camera(), {}), render(scene, facing_camera(), {}));
}

}  // namespace
}  // namespace lightbench
