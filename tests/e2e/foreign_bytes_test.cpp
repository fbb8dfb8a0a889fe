// File names are bytes: those that are not UTF-8 work like any other, and reports show them as U+FFFD.
#include "run_fixture.h"

namespace lightbench {
namespace {

using test::GlRun;
using ::testing::HasSubstr;
using ::testing::Not;

class GlForeignBytes : public GlRun {
 protected:
  GlForeignBytes() {
    write("jobs\xE9/box.obj", "mtllib b\xF6x.mtl\nusemtl gr\xE4y\nvt 0 0\n" + kBox);
    write("jobs\xE9/b\xF6x.mtl", "newmtl gr\xE4y\nKd 0.6 0.5 0.4\nmap_Kd caf\xE9.png\n");
    write_png(path("jobs\xE9/caf\xE9.png"), Image8(4, 4, 3, 100));
    for (const char* file : {"cameras.json", "job.json"})
      write(std::string("jobs\xE9/") + file, read_file(path(file)));
    write("jobs\xE9/scene.json",
          R"({"entities": [{"obj": "box.obj"}], "lights": [{"type": "point", "position": [2, 3, 4]}]})");
  }

  ProcessResult run_foreign() const { return run({"run", "jobs\xE9/job.json", "--out", "out\xE9"}); }
};

TEST_F(GlForeignBytes, InTheNamesOfTexturesJobsAndFolders) {
  const auto result = run_foreign();
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("out\uFFFD/index.html"));
  EXPECT_TRUE(std::filesystem::exists(path("out\xE9/views/box/front/lit~truth.score.json")));
  EXPECT_THAT(read_file(path("out\xE9/run.json")), HasSubstr("jobs\U0010FFE9/job.json"));
  EXPECT_THAT(read_file(path("out\xE9/index.html")), HasSubstr("jobs\uFFFD/job.json"));
  EXPECT_THAT(run_foreign().out, HasSubstr("0 tasks to do, 13 there already"));
  EXPECT_EQ(run({"score", "out\xE9"}).exit_code, 0);
  EXPECT_EQ(run({"report", "out\xE9"}).exit_code, 0);
}

TEST_F(GlForeignBytes, InTheNamesThatOtherCommandsRead) {
  const std::string scene = "jobs\xE9/scene.json";
  EXPECT_THAT(run({"scene", "check", scene}).out, HasSubstr("fine"));
  EXPECT_EQ(run({"render", scene, "--size", "32x24", "-o", "p\xE9.png"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("p\xE9.png")));
  EXPECT_EQ(run({"export", scene, "--cameras", "cameras.json", "-o", "pov\xE9"}).exit_code, 0);
  EXPECT_EQ(run({"bench", "jobs\xE9/job.json", "--rounds", "2", "-o", "bench\xE9.json"}).exit_code, 0);
  EXPECT_THAT(run({"plan", "jobs\xE9/job.json", "--json", "--out", "out\xE9"}).out,
              HasSubstr("jobs\U0010FFE9"));
}

TEST_F(GlForeignBytes, InTheNameOfAJobItself) {
  write("jobs\xE9/j\366b.json",
        R"({"scenes": [{"scene": "box.obj", "random": {"count": 1}}], "size": [32, 24],
      "variants": [{"technique": "direct"}]})");
  const auto result = run({"run", "jobs\xE9/j\366b.json"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_TRUE(std::filesystem::exists(path("out/j%F6b/index.html")));
  EXPECT_THAT(read_file(path("out/j%F6b/index.html")), Not(HasSubstr("\366b")));
}

}  // namespace
}  // namespace lightbench
