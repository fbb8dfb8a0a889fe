#include "e2e_fixture.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

/// Runs of a small job with a stand-in for POV-Ray.
class GlRun : public test::Program {
 protected:
  GlRun() {
    write_job("");
    fake_povray(copy_picture());
  }

  /// `more` goes into the job as further keys.
  void write_job(const std::string& more) const {
    write("job.json", R"({"name": "job", "size": [32, 24],
      "scenes": [{"name": "box", "scene": "scene.json", "cameras": "cameras.json"}],
      "variants": [{"name": "direct", "technique": "direct", "params": {"shadows": "none"}},
                   {"name": "lit", "technique": "ambient", "params": {"shadows": "none"}}],
      "references": [{"name": "truth", "kind": "povray"}])" +
                          more + "}");
  }

  ProcessResult run_job(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", "job.json", "--out", "out"});
    return run(more);
  }
  Json report() const { return Json::parse(read_file(path("out/run.json"))); }

  std::size_t lines_of_ledger() const {
    const std::string text = read_file(path("out/ledger.jsonl"));
    return std::size_t(std::count(text.begin(), text.end(), '\n'));
  }
  std::size_t pictures(const std::string& ending) const {
    std::size_t count = 0;
    for (const auto& file : files("out")) count += file.ends_with(ending);
    return count;
  }

  static constexpr std::size_t kTasks = 13;  // 4 snapshots, 2 references, 3 exports, 4 scores
};

TEST_F(GlRun, MakesEveryPictureScoreAndReport) {
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_EQ(lines_of_ledger(), kTasks);
  for (const char* file :
       {"out/index.html", "out/run.json", "out/junit.xml", "out/summary.md", "out/views/box/front/direct.exr",
        "out/views/box/front/lit.png", "out/views/box/side/truth.pov", "out/views/box/side/truth.exr",
        "out/views/box/side/lit~truth.diff.png", "out/views/box/side/lit~truth.heat.png",
        "out/views/box/side/lit~direct.diff.png"})
    EXPECT_TRUE(std::filesystem::exists(path(file))) << file;
  EXPECT_THAT(result.out, HasSubstr("out/index.html"));
}

TEST_F(GlRun, NoTemporaryFileStays) {
  run_job();
  for (const auto& file : files()) EXPECT_THAT(file, Not(HasSubstr("tmp")));
}

TEST_F(GlRun, ASecondRunDoesNothing) {
  run_job();
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("0 tasks to do, 13 there already"));
  EXPECT_EQ(lines_of_ledger(), kTasks);
}

TEST_F(GlRun, PlanExplainSaysWhichPartOfAKeyChanged) {
  run_job();
  write("box.mtl", "newmtl grey\nKd 0.1 0.5 0.4\n");
  const auto result = run({"plan", "job.json", "--out", "out", "--explain"});
  EXPECT_THAT(result.out, HasSubstr("snapshot:box/front/direct  to do: changed: file box.mtl"));
  EXPECT_THAT(result.out, HasSubstr("export:box/front/truth"));
}

TEST_F(GlRun, ADamagedPictureIsMadeAgain) {
  run_job();
  write("out/views/box/front/lit.png", "not a picture");
  EXPECT_THAT(run_job().out, HasSubstr("1 task to do, 12 there already"));
  EXPECT_EQ(read_image_srgb8(path("out/views/box/front/lit.png")).width, 32);
}

TEST_F(GlRun, AGateThatIsNotMetIsExitCode1) {
  write_job(R"(, "gates": [{"metric": "gain", "variant": "lit", "min": 100}])");
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  EXPECT_EQ(report().at("gates").at(0).at("state"), "not met");
}

TEST_F(GlRun, AGateThatIsMetIsExitCode0) {
  write_job(R"(, "gates": [{"metric": "mean_error", "variant": "*", "max": 255}])");
  EXPECT_EQ(run_job().exit_code, 0);
}

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

TEST_F(GlRun, StagesOneAfterTheOther) {
  EXPECT_EQ(run_job({"--stages", "snapshot"}).exit_code, 0);
  EXPECT_EQ(pictures("truth.exr"), 0u);
  EXPECT_EQ(run_job({"--stages", "score"}).exit_code, 2);  // nothing to compare with yet
  EXPECT_EQ(run_job({"--stages", "reference"}).exit_code, 0);
  EXPECT_EQ(pictures(".score.json"), 0u);
  EXPECT_EQ(run({"score", "out"}).exit_code, 0);
  EXPECT_EQ(pictures(".score.json"), 4u);
}

TEST_F(GlRun, OnlyWhatIsAskedForAndWhatItNeeds) {
  EXPECT_EQ(run_job({"--only", "box/front/lit"}).exit_code, 0);
  EXPECT_EQ(pictures(".score.json"), 1u);
  EXPECT_EQ(pictures("front/direct.png"), 1u);  // the baseline
  EXPECT_TRUE(files("out/views/box").contains("out/views/box/front/truth.png"));
  EXPECT_FALSE(std::filesystem::exists(path("out/views/box/side")));
}

TEST_F(GlRun, OnlyWhatDoesNotExistIsAnError) {
  EXPECT_EQ(run_job({"--only", "nothing*"}).exit_code, 3);
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

TEST_F(GlRun, PicturesOfAnotherEngineAreScored) {
  write_png(path("mine/box-front.png"), Image8(32, 24, 3, 188));  // the sRGB of what the fake POV-Ray shows
  write_png(path("mine/box-side.png"), Image8(32, 24, 3, 100));
  std::string text = read_file(path("job.json"));
  const std::string place = R"("variants": [)";
  write("job.json",
        text.replace(text.find(place), place.size(), place + R"({"name": "mine", "technique": "images",
                                             "params": {"pattern": "mine/{scene}-{view}.png"}},)"));
  EXPECT_EQ(run_job().exit_code, 0);
  const auto score = Json::parse(read_file(path("out/views/box/front/mine~truth.score.json")));
  EXPECT_EQ(score.at("metrics").at("mean_error"), 0.0);
  write_png(path("mine/box-side.png"), Image8(32, 24, 3, 120));
  EXPECT_THAT(run_job().out, HasSubstr("snapshot:box/side/mine done"));
}

TEST_F(GlRun, NamesAreDataWhateverTheyAre) {
  write("cameras.json", R"JSON({"views": [{"name": "../../<b>$(touch x)\"", "position": [0.5, 0.5, 4],
                                     "look_at": [0.5, 0.5, 0]}]})JSON");
  std::string text = read_file(path("job.json"));
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"box\"", "\"; rm -rf / #include\""},
                                 {"\"lit\"", "\"l/i\\u0416t ~\""}})
    text.replace(text.find(from), from.size(), to);
  write("job.json", text);
  const auto before = files();
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  for (const auto& file : files())
    EXPECT_TRUE(before.contains(file) || file == "grey.exr" || file.starts_with("out/"))
        << file << " is outside the run's folder";
  EXPECT_EQ(report().at("scores").size(), 2u);
}

TEST_F(GlRun, ScoresCanBeMadeFromAnotherFolder) {
  EXPECT_EQ(run_job().exit_code, 0);
  std::filesystem::remove(path("out/views/box/front/lit~truth.heat.png"));
  const auto result = run_process({.argv = {LIGHTBENCH_BINARY, "score", path("out").string()},
                                   .working_directory = "/",
                                   .environment = environment_});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(pictures("lit~truth.heat.png"), 2u);
}

TEST_F(GlRun, AnOracleIsARunOfItsOwnWithATable) {
  const std::string variants = R"("variants": [{"name": "direct", "technique": "direct"},
      {"name": "fast", "technique": "isr", "preset": "fast"}],)";
  std::string job = read_file(path("job.json"));
  const auto first = job.find("\"variants\""), end = job.find("\"references\"");
  write("job.json", job.replace(first, end - first, variants));
  const auto result = run({"oracle", "job.json"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("lost by searching"));
  EXPECT_THAT(result.out, HasSubstr("mean of 2 views"));
  EXPECT_THAT(read_file(path("out/job-oracle/oracle.md")), HasSubstr("| box/side | fast |"));
  EXPECT_TRUE(std::filesystem::exists(path("out/job-oracle/views/box/side/fast,%20oracle.png")));
  const std::string ledger = read_file(path("out/job-oracle/ledger.jsonl"));
  EXPECT_EQ(run({"run", "out/job-oracle/oracle.json"}).exit_code, 0);
  EXPECT_EQ(read_file(path("out/job-oracle/ledger.jsonl")), ledger) << "nothing was left to do";
}

TEST_F(GlRun, AnOracleNeedsAVariantOfIsr) {
  const auto result = run({"oracle", "job.json"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("job.json: no variant is of technique 'isr'"));
}

TEST_F(GlRun, SweepsAndRandomViewsAndBuffers) {
  write("job.json", R"({"size": [32, 24], "scenes": [{"scene": "box.obj", "random": {"count": 2, "seed": 3}}],
      "variants": [{"name": "lit", "technique": "ambient", "params": {"shadows": "none"}, "sweep": {"k": [0.1, 0.5]}}],
      "buffers": ["albedo", "depth"]})");
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_EQ(pictures("lit[k=0.5].png"), 2u);
  EXPECT_EQ(pictures("~~depth.exr"), 4u);
  EXPECT_TRUE(std::filesystem::exists(path("out/cameras/box.json")));
  EXPECT_THAT(run_job().out, HasSubstr("0 tasks to do"));
}

TEST_F(GlRun, ReportsCanBeWrittenAgain) {
  run_job();
  std::filesystem::remove(path("out/index.html"));
  EXPECT_EQ(run({"report", "out"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("out/index.html")));
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

TEST_F(GlRun, BenchTimesEveryVariantApart) {
  const auto result = run({"bench", "job.json", "--rounds", "2", "-o", "bench.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("box/front/lit"));
  const auto json = Json::parse(read_file(path("bench.json")));
  EXPECT_EQ(json.at("rows").size(), 4u);
  EXPECT_GT(json.at("rows").at(0).at("passes").at(0).at("median_seconds").get<double>(), 0);
}

/// Runs without POV-Ray: references and a variant are path-traced.
class GlPathTracedRun : public GlRun {
 protected:
  GlPathTracedRun() {
    environment_["LIGHTBENCH_POVRAY"] = path("absent").string();
    write("job.json", R"({"name": "job", "size": [32, 24],
      "scenes": [{"name": "box", "scene": "scene.json", "cameras": "cameras.json"}],
      "variants": [{"name": "direct", "technique": "direct"},
                   {"name": "paths", "technique": "path_tracer", "params": {"samples": 32, "seed": 2}}],
      "references": [{"name": "two", "kind": "path_tracer", "params": {"samples": 8}},
                     {"name": "all", "kind": "path_tracer", "preset": "converged", "params": {"samples": 8}}],
      "metrics": ["mean_error", "gain"]})");
  }
};

TEST_F(GlPathTracedRun, TellsHowExactItsReferencesAre) {
  const auto result = run_job();
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("two (2 bounces) has "));
  const Json made = report();
  for (const Json& image : made.at("images")) {
    if (!image.at("is_reference").get<bool>()) continue;
    // A lone box gets light from the lamp alone, which is exact.
    EXPECT_EQ(image.at("noise").get<double>(), 0) << image;
    EXPECT_GT(image.at("mean_luminance").get<double>(), 0);
    EXPECT_GT(image.at("ray_rates").at("diffuse").get<double>(), 0);
    EXPECT_FALSE(image.contains("pov"));
  }
  EXPECT_EQ(pictures(".pov"), 0u);
}

TEST_F(GlPathTracedRun, ItsImagesSayWhatTheyAre) {
  ASSERT_EQ(run_job().exit_code, 0);
  const ImageMetadata metadata = read_image_metadata(path("out/views/box/front/all.exr"));
  EXPECT_EQ(metadata.at("lightbench:reference"), "path_tracer");
  EXPECT_EQ(metadata.at("lightbench:bounces"), "16");
  EXPECT_THAT(metadata.at("lightbench:tool"), HasSubstr("Embree"));
  EXPECT_THAT(metadata.at("lightbench:settings"), HasSubstr("samples=8"));
  EXPECT_EQ(metadata.at("lightbench:scene"), report().at("scenes").at(0).at("hash"));
}

TEST_F(GlPathTracedRun, GainsHaveACeiling) {
  ASSERT_EQ(run_job().exit_code, 0);
  EXPECT_THAT(read_file(path("out/summary.md")), HasSubstr(" / "));
}

TEST_F(GlPathTracedRun, ASecondRunDoesNothing) {
  ASSERT_EQ(run_job().exit_code, 0);
  EXPECT_THAT(run_job().out, HasSubstr("0 tasks to do"));
}

TEST_F(GlPathTracedRun, BenchLeavesPathsOut) {
  const auto result = run({"bench", "job.json", "--rounds", "1", "-o", "bench.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Json::parse(read_file(path("bench.json"))).at("rows").size(), 2u);
}

/// A box that moves, in two frames of one view.
class GlSequence : public GlRun {
 protected:
  GlSequence() {
    write(
        "scene.json",
        R"({"entities": [{"obj": "box.obj", "keyframes": [{"time": 0}, {"time": 1, "translate": [0.5, 0, 0]}]}],
              "lights": [{"type": "point", "position": [2, 3, 4]}]})");
    write("job.json", R"({"name": "job", "size": [32, 24],
      "scenes": [{"name": "box", "scene": "scene.json", "cameras": "cameras.json", "views": ["front"],
                  "sequence": {"frames": 2, "rate": 1}}],
      "variants": [{"name": "direct", "technique": "direct", "params": {"shadows": "none"}}],
      "references": [{"name": "truth", "kind": "povray"}]})");
  }

  std::string frame_file(int frame, const std::string& name) const {
    return read_file(path("out/views/box/front.00" + std::to_string(frame) + "/" + name));
  }
};

TEST_F(GlSequence, EachFrameIsDrawnAndExportedAtItsTime) {
  const auto result = run_job();
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_NE(frame_file(0, "direct.png"), frame_file(1, "direct.png"));
  EXPECT_THAT(frame_file(0, "truth.pov"), HasSubstr("object{M1}"));
  EXPECT_THAT(frame_file(1, "truth.pov"), HasSubstr("object{M1 matrix<"));
}

TEST_F(GlSequence, AFrameIsWhatRenderGivesAtItsTime) {
  run_job();
  run({"render", "scene.json", "--cameras", "cameras.json", "--view", "front", "--time", "1", "--size",
       "32x24", "-p", "shadows=none", "-o", "alone.exr"});
  EXPECT_EQ(read_image_srgb8(path("out/views/box/front.001/direct.exr")),
            read_image_srgb8(path("alone.exr")));
}

TEST_F(GlSequence, TheSecondFrameHasAFlicker) {
  run_job();
  const Json scores = report()["scores"];
  ASSERT_EQ(scores.size(), 2u);
  EXPECT_THAT(scores[0]["metrics"]["flicker"]["undefined"], HasSubstr("no frame before"));
  // The reference is the same grey in both frames, and the pictures differ.
  EXPECT_GT(scores[1]["metrics"]["flicker"].get<double>(), 0);
  EXPECT_EQ(report()["sequences"][0]["frames"][1]["view"], "front.001");
  EXPECT_THAT(read_file(path("out/summary.md")), HasSubstr("### Sequences"));
}

TEST_F(GlSequence, ASecondRunDoesNothing) {
  run_job();
  EXPECT_THAT(run_job().out, HasSubstr("0 tasks to do, 9 there already"));
}

TEST_F(GlSequence, AnotherRateMakesOnlyWhatItMoves) {
  run_job();
  const std::string text = read_file(path("job.json"));
  write("job.json", std::string(text).replace(text.find(R"("rate": 1)"), 9, R"("rate": 2)"));
  // The second frame's picture, its text, its reference and its score.
  EXPECT_THAT(run_job().out, HasSubstr("4 tasks to do, 5 there already"));
}

TEST_F(GlSequence, KeyframesThatAreWrongAreAnErrorWithTheirPlace) {
  write("scene.json", R"({"entities": [{"obj": "box.obj", "keyframes": [{"time": 1}, {"time": 0}]}]})");
  const auto result = run({"scene", "check", "scene.json"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out, HasSubstr("scene.json: $.entities[0].keyframes[1].time: error"));
}

}  // namespace
}  // namespace lightbench
