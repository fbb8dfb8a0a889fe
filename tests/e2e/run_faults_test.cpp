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

TEST_F(GlRun, ScoringAfterAFailureTellsItAgain) {
  fake_povray("echo 'it is dark here' >&2; exit 1");
  EXPECT_EQ(run_job().exit_code, 2);
  const auto result = run({"score", "out"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.out, HasSubstr("failed: box/front truth"));
  EXPECT_THAT(result.out, HasSubstr("it is dark here"));
  EXPECT_EQ(run({"report", "out"}).exit_code, 2) << "the stored report knows it as well";
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

// Workers that begin after the edit, with the plan that was made before it.
TEST_F(GlRun, AnEditedSceneFailsTheTasksThatLoadIt) {
  EXPECT_EQ(run_job({"--stages", "snapshot"}).exit_code, 0);
  const std::string planned = read_file(path("box.mtl"));
  write("box.mtl", "newmtl grey\nKd 1 0 0\n");
  const auto picture = read_image_srgb8(path("out/views/box/front/lit.png"));
  for (const char* task : {"snapshot:box/front/lit", "export:box/povray", "export:box/side/truth"}) {
    const auto result = run({"work", "out/plan.json", task});
    EXPECT_THAT(result.out, HasSubstr(std::string("fail ") + task)) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("the scene's files changed while the run went on")) << result.out;
  }
  EXPECT_EQ(read_image_srgb8(path("out/views/box/front/lit.png")), picture);
  write("box.mtl", planned);
  EXPECT_THAT(run({"work", "out/plan.json", "snapshot:box/front/lit"}).out, HasSubstr("done snapshot"));
}

TEST_F(GlRun, AnEditedPictureOfAnotherEngineFailsItsTask) {
  add_pictures(100);
  EXPECT_EQ(run_job({"--stages", "snapshot"}).exit_code, 0);
  write_png(path("mine/box-side.png"), Image8(32, 24, 3, 200));
  const auto result = run({"work", "out/plan.json", "snapshot:box/side/mine", "snapshot:box/front/mine"});
  EXPECT_THAT(result.out, HasSubstr("fail snapshot:box/side/mine \"the picture was changed while the run"));
  EXPECT_THAT(result.out, HasSubstr("done snapshot:box/front/mine"));
  EXPECT_EQ(read_image_srgb8(path("out/views/box/side/mine.png")), Image8(32, 24, 3, 100));
}

TEST_F(GlRun, AReferenceOfAnEditedExportIsNotKept) {
  fake_povray("echo '// edited' >> '" + path("out/povray/box/scene.inc").string() + "'\n" + copy_picture());
  const auto result = run_job({"--jobs", "1"});
  EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("povray/box/scene.inc was changed while the run went on"));
  fake_povray(copy_picture());
  EXPECT_EQ(run_job().exit_code, 0);
}

TEST_F(GlRun, AScoreOfAnEditedPictureIsNotKept) {
  // POV-Ray comes last here: the pictures that it is compared with are there already.
  EXPECT_EQ(run_job({"--stages", "snapshot"}).exit_code, 0);
  fake_povray("cp '" + path("grey.exr").string() + "' '" + path("out/views/box/front/lit.exr").string() +
              "'\n" + copy_picture());
  const auto result = run_job({"--jobs", "1"});
  EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("views/box/front/lit.exr was changed while the run went on"));
  fake_povray(copy_picture());
  EXPECT_EQ(run_job().exit_code, 0);
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
  EXPECT_FALSE(std::filesystem::exists(path("out/.lightbench-tmp")));
  const std::size_t done = lines_of_ledger();
  EXPECT_GT(done, 0u);
  fake_povray(copy_picture());
  const auto second = run_job();
  EXPECT_EQ(second.exit_code, 0) << second.out << second.err;
  EXPECT_THAT(second.out, HasSubstr(std::to_string(done) + " there already"));
  EXPECT_EQ(lines_of_ledger(), kTasks);
}

TEST_F(GlRun, AKilledRunGoesOnLaterAndLeavesNothing) {
  std::filesystem::create_directory(path("tmp"));
  environment_["TMPDIR"] = path("tmp").string();
  fake_povray("kill -KILL " + std::string(kParentOfWorker) + "; sleep 5");
  EXPECT_EQ(run_job({"--jobs", "1"}).signal, SIGKILL);
  EXPECT_TRUE(std::filesystem::exists(path("out/.lightbench-tmp")));
  const std::size_t done = lines_of_ledger();
  fake_povray(copy_picture());
  const auto second = run_job();
  EXPECT_EQ(second.exit_code, 0) << second.out << second.err;
  EXPECT_THAT(second.out, HasSubstr(std::to_string(done) + " there already"));
  for (const auto& file : files("out")) EXPECT_THAT(file, Not(HasSubstr("tmp"))) << file;
  EXPECT_FALSE(std::filesystem::exists(path("out/.lightbench-tmp")));
  EXPECT_TRUE(std::filesystem::is_empty(path("tmp")));
}

TEST_F(GlRun, WhatAWorkerLeavesThatIsKilledWhileItWritesIsRemoved) {
  EXPECT_EQ(run_job().exit_code, 0);
  std::filesystem::remove(path("out/views/box/front/lit.exr"));
  // As soon as a file has 512 bytes.
  const std::string work =
      "ulimit -f 1; exec '" LIGHTBENCH_BINARY "' work out/plan.json snapshot:box/front/lit";
  EXPECT_EQ(run_process({.argv = {"sh", "-c", work},
                         .working_directory = folder_.path(),
                         .environment = {{"MESA_SHADER_CACHE_DISABLE", "true"}}})
                .signal,
            SIGXFSZ);
  EXPECT_EQ(files_called("tmp"), 1u);
  EXPECT_EQ(run_job().exit_code, 0);
  EXPECT_EQ(files_called("tmp"), 0u);
}

TEST_F(GlRun, ClosedStreamsRuinNothing) {
  for (const char* closed : {"<&-", ">&-", "2>&-", "<&- >&- 2>&-"}) {
    std::filesystem::remove_all(path("out"));
    const std::string command =
        std::string("exec '") + LIGHTBENCH_BINARY + "' run job.json --out out " + closed;
    const auto result = run_process(
        {.argv = {"sh", "-c", command}, .working_directory = folder_.path(), .environment = environment_});
    EXPECT_EQ(result.exit_code, 0) << closed << result.out << result.err;
    EXPECT_EQ(lines_of_ledger(), kTasks) << closed;
    EXPECT_THAT(run_job().out, HasSubstr("0 tasks to do, 13 there already")) << closed;
  }
}

TEST_F(GlRun, ALinkBelowItsFolderLeadsNothingOut) {
  std::filesystem::create_directory(path("elsewhere"));
  write("out/ledger.jsonl", "");  // of a run that was killed at once
  for (const char* name : {"views", "povray"}) {
    std::filesystem::create_directory_symlink("../elsewhere", path("out") / name);
    const auto result = run_job();
    EXPECT_EQ(result.exit_code, 3) << result.out;
    EXPECT_THAT(result.err, HasSubstr(path("out").string() + "/" + name + ": is a link"));
    EXPECT_TRUE(std::filesystem::is_empty(path("elsewhere"))) << name;
    std::filesystem::remove(path("out") / name);
  }
  write("job.json", R"({"scenes": [{"scene": "box.obj", "random": {"count": 1}}],
      "variants": [{"technique": "direct"}]})");
  std::filesystem::create_directory_symlink("../elsewhere", path("out/cameras"));
  EXPECT_EQ(run_job().exit_code, 3);
  EXPECT_TRUE(std::filesystem::is_empty(path("elsewhere")));
}

TEST_F(GlRun, AWorkerDoesNotFollowALinkThatCameLater) {
  EXPECT_EQ(run_job().exit_code, 0);
  std::filesystem::create_directory(path("elsewhere"));
  std::filesystem::remove_all(path("out/views/box"));
  std::filesystem::create_directory_symlink("../../elsewhere", path("out/views/box"));
  const auto result = run({"work", "out/plan.json", "snapshot:box/front/lit"});
  EXPECT_THAT(result.out, HasSubstr("is a link"));
  EXPECT_TRUE(std::filesystem::is_empty(path("elsewhere")));
}

TEST_F(GlRun, AFolderOfAnotherProgramsFilesKeepsThem) {
  write("out/tmp/notes", "mine");
  write("out/ledger.jsonl", "my ledger: 12 apples");
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("out/ledger.jsonl: is not a ledger"));
  EXPECT_EQ(read_file(path("out/ledger.jsonl")), "my ledger: 12 apples");
  std::filesystem::remove(path("out/ledger.jsonl"));
  const auto refused = run_job();
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("out: holds files, such as tmp, but no run of lightbench"));
  EXPECT_EQ(files("out"), (std::set<std::string>{"out/tmp/notes"}));
}

TEST_F(GlRun, AWorkerReadsItsTasksFromItsInput) {
  EXPECT_EQ(run_job().exit_code, 0);
  const auto result = run_process({.argv = {LIGHTBENCH_BINARY, "work", path("out/plan.json").string()},
                                   .input = "snapshot:box/front/lit\nsnapshot:box/side/lit\n"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("\ndone snapshot:box/front/lit {"));
  EXPECT_THAT(result.out, HasSubstr("\ndone snapshot:box/side/lit {"));
}

TEST_F(GlRun, ItGoesOnAfterItsTerminalIsGone) {
  fake_povray("kill -HUP " + std::string(kParentOfWorker) + "\n" + copy_picture());
  const auto result = run_process({.argv = {"nohup", LIGHTBENCH_BINARY, "run", "job.json", "--out", "out"},
                                   .working_directory = folder_.path(),
                                   .environment = environment_});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_EQ(lines_of_ledger(), kTasks);
}

TEST_F(GlRun, WhatPovraySaysCannotSteerATerminal) {
  fake_povray("printf 'red \\033[31m\\n' >&2; exit 1");
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.out, HasSubstr("red \uFFFD[31m"));
  EXPECT_THAT(result.out + result.err, Not(HasSubstr("\x1b")));
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
