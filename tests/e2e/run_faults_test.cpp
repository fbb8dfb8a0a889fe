#include "run_fixture.h"

/// Runs in which something fails, hangs or is killed.
namespace lightbench {
namespace {

using test::GlRun;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(GlRun, AFailingReferenceIsOneRowAndTheRestIsDone) {
  fake_povray("case \"$(readlink scene.pov)\" in */front/*) echo 'it is dark here' >&2; exit 1;; esac\n" +
              copy_picture());
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("reference:box/front/truth FAILED"));
  EXPECT_THAT(result.out, HasSubstr("it is dark here"));
  EXPECT_FALSE(std::filesystem::exists(path("out/views/box/front/truth.png")));
  EXPECT_TRUE(std::filesystem::exists(path("out/views/box/side/lit~truth.score.json")));
}

TEST_F(GlRun, AFailedTaskIsTriedAgain) {
  fake_povray("exit 1");
  EXPECT_EQ(run_job().exit_code, 2);
  fake_povray(copy_picture());
  EXPECT_EQ(run_job().exit_code, 0);
  EXPECT_EQ(pictures("truth.png"), 2u);
}

TEST_F(GlRun, AReferenceWithoutAnImageHasFailed) {
  fake_povray("exit 0");
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.out, HasSubstr("wrote no image"));
}

TEST_F(GlRun, AHangingReferenceIsStopped) {
  write_job("");
  write("job.json", [&] {
    std::string text = read_file(path("job.json"));
    return text.replace(text.find(R"("kind": "povray")"), 16, R"("kind": "povray", "timeout": 0.5)");
  }());
  fake_povray("sleep 60");
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.out, HasSubstr("timed out"));
}

TEST_F(GlRun, ABrokenSceneFailsItsOwnTasksAlone) {
  write("broken.json", R"({"entities": [{"obj": "nowhere.obj"}]})");
  std::string text = read_file(path("job.json"));
  const std::string place = R"("scenes": [)";
  write("job.json",
        text.replace(text.find(place), place.size(),
                     place + R"({"name": "broken", "scene": "broken.json", "cameras": "cameras.json"},)"));
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("nowhere.obj"));
  EXPECT_EQ(pictures("~truth.score.json"), 4u);
}

TEST_F(GlRun, AKilledWorkerLosesOnlyItsTask) {
  fake_povray("case \"$(readlink scene.pov)\" in */front/*) kill -9 $PPID; sleep 5;; esac\n" +
              copy_picture());
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
  EXPECT_THAT(result.out,
              HasSubstr("reference:box/front/truth FAILED: its worker ended: killed by signal 9"));
  EXPECT_EQ(pictures("side/truth.png"), 1u);
  EXPECT_EQ(pictures("lit.png"), 2u);
}

/// The run is the parent of the worker, which is the parent of POV-Ray.
const char* const kParentOfWorker = "$(awk '{print $4}' /proc/$PPID/stat)";

TEST_F(GlRun, AnInterruptedRunGoesOnLater) {
  fake_povray("kill -TERM " + std::string(kParentOfWorker) + "; sleep 5");
  const auto first = run_job({"--jobs", "1"});
  EXPECT_EQ(first.exit_code, 2) << first.out << first.err;
  EXPECT_THAT(first.out, HasSubstr("interrupted"));
  EXPECT_FALSE(std::filesystem::exists(path("out/tmp")));
  const std::size_t done = lines_of_ledger();
  EXPECT_GT(done, 0u);
  fake_povray(copy_picture());
  const auto second = run_job();
  EXPECT_EQ(second.exit_code, 0) << second.out << second.err;
  EXPECT_THAT(second.out, HasSubstr(std::to_string(done) + " there already"));
  EXPECT_EQ(lines_of_ledger(), kTasks);
}

TEST_F(GlRun, AKilledRunGoesOnLater) {
  fake_povray("kill -KILL " + std::string(kParentOfWorker) + "; sleep 5");
  EXPECT_EQ(run_job({"--jobs", "1"}).signal, SIGKILL);
  const std::size_t done = lines_of_ledger();
  fake_povray(copy_picture());
  const auto second = run_job();
  EXPECT_EQ(second.exit_code, 0) << second.out << second.err;
  EXPECT_THAT(second.out, HasSubstr(std::to_string(done) + " there already"));
  EXPECT_FALSE(std::filesystem::exists(path("out/tmp")));
}

TEST_F(GlRun, TwoRunsInOneFolderAreKeptApart) {
  fake_povray("'" + std::string(LIGHTBENCH_BINARY) + "' run '" + path("job.json").string() + "' --out '" +
              path("out").string() + "' 2> '" + path("second.txt").string() + "'\n" + copy_picture());
  EXPECT_EQ(run_job({"--jobs", "1"}).exit_code, 0);
  EXPECT_THAT(read_file(path("second.txt")), HasSubstr("another run is working in this folder"));
}

TEST_F(GlRun, AFullDiskIsAClearErrorAndLeavesNothingHalfWritten) {
  std::filesystem::create_directories(path("small"));
  const std::string mount = "mount -t tmpfs -o size=64k tmpfs '" + path("small").string() + "'";
  const std::string unshare = "unshare --map-root-user --mount sh -c ";
  if (!run_process({.argv = {"sh", "-c", unshare + "\"" + mount + "\""}}).ok())
    GTEST_SKIP() << "this machine does not let us mount a small file system";
  const auto result = run_process(
      {.argv = {"sh", "-c",
                unshare + "\"" + mount + " && cd '" + folder_.path().string() + "' && '" + LIGHTBENCH_BINARY +
                    "' run job.json --out small/out; code=\\$?; "
                    "find small -name '*tmp*'; exit \\$code\""},
       .environment = environment_});
  EXPECT_THAT(result.exit_code, ::testing::AnyOf(2, 3)) << result.out << result.err;
  EXPECT_THAT(result.out + result.err, HasSubstr("No space left"));
  EXPECT_THAT(result.out, Not(HasSubstr(".tmp")));
}

TEST_F(GlRun, WithoutPovrayNothingIsBegun) {
  environment_["LIGHTBENCH_POVRAY"] = "/nowhere/povray";
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("POV-Ray is not there"));
  EXPECT_EQ(pictures(".png"), 0u);
}

TEST_F(GlRun, WithoutPovraySnapshotsArePossible) {
  environment_["LIGHTBENCH_POVRAY"] = "/nowhere/povray";
  EXPECT_EQ(run_job({"--stages", "snapshot"}).exit_code, 0);
  EXPECT_EQ(pictures(".png"), 4u);
}

}  // namespace
}  // namespace lightbench
