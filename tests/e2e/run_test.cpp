#include "run_fixture.h"

namespace lightbench {
namespace {

using test::GlRun;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

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

TEST_F(GlRun, AGateThatIsMeasuredOnAPartOfItsViewsIsExitCode5) {
  write_job(R"(, "gates": [{"metric": "mean_error", "variant": "*", "max": 255}])");
  const auto part = run_job({"--only", "box/front/*"});
  EXPECT_EQ(part.exit_code, 5) << part.out << part.err;
  EXPECT_THAT(part.out, HasSubstr("gate NOT JUDGED"));
  EXPECT_THAT(part.out, HasSubstr("1 of 1 gate not judged"));
  EXPECT_EQ(run({"report", "out"}).exit_code, 5);
  EXPECT_EQ(run_job({"--only", "box/front/*", "--partial"}).exit_code, 0);
  EXPECT_EQ(report().at("gates").at(0).at("state"), "met");
  EXPECT_EQ(run_job().exit_code, 0) << "now all views are measured";
}

TEST_F(GlRun, AGateWithoutScoresIsExitCode5) {
  write_job(R"(, "gates": [{"metric": "mean_error", "variant": "*", "max": 255}])");
  EXPECT_EQ(run_job({"--stages", "snapshot"}).exit_code, 5);
  EXPECT_EQ(run_job({"--stages", "snapshot", "--partial"}).exit_code, 0);
}

TEST_F(GlRun, AJobIsNotReplacedByTheFilesOfItsRun) {
  const std::string job = read_file(path("job.json"));
  write("run.json", job);
  const auto result = run({"run", "run.json", "--out", "."});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("the job would be overwritten by the run's run.json"));
  EXPECT_EQ(read_file(path("run.json")), job);
}

/// A file that the job's scene or variant reads, put where the run would write, and the job that reads it
/// there.
struct KeptFile {
  const char* what;
  const char* output;
  const char* old_place;
  const char* reader;  ///< the file that names it
};

TEST_F(GlRun, WhatScenesAndVariantsReadIsNotReplaced) {
  add_pictures(188);
  const KeptFile cases[] = {
      {"an OBJ", "out/summary.md", "box.obj", "scene.json"},
      {"an MTL", "out/index.html", "box.mtl", "box.obj"},
      {"an OBJ at a picture's place", "out/views/box/front/lit.png", "box.obj", "scene.json"},
      {"an OBJ among exported files", "out/povray/box/mine.obj", "box.obj", "scene.json"},
      {"a picture of another engine", "out/views/box/front/direct.png", "mine/box-front.png", "job.json"},
  };
  for (const KeptFile& kept : cases) {
    const std::string text = read_file(path(kept.reader)), content = read_file(path(kept.old_place));
    std::filesystem::create_directories(path(kept.output).parent_path());
    write("out/ledger.jsonl", "");  // it is the folder of a run
    write(std::filesystem::path(kept.output).parent_path() / "box.mtl", read_file(path("box.mtl")));
    write(kept.output, content);
    const std::string name =
        kept.reader == std::string("job.json") ? "mine/{scene}-{view}.png" : kept.old_place;
    std::string moved = text;
    write(kept.reader, moved.replace(moved.find(name), name.size(), kept.output));
    const auto result = run_job();
    EXPECT_EQ(result.exit_code, 3) << kept.what << result.out << result.err;
    EXPECT_THAT(result.err, HasSubstr("would be overwritten by the run")) << kept.what;
    EXPECT_EQ(read_file(path(kept.output)), content) << kept.what;
    write(kept.reader, text);
    std::filesystem::remove_all(path("out"));
  }
}

TEST_F(GlRun, WhatIsNoFileInAFilesPlaceIsFoundBeforeTheWork) {
  for (const char* name : {"out/index.html", "out/run.json", "out/views/box/front/lit.png"}) {
    std::filesystem::create_directories(path(name));
    write("out/ledger.jsonl", "");  // it is the folder of a run
    const auto result = run_job();
    EXPECT_EQ(result.exit_code, 3) << name;
    EXPECT_THAT(result.err, HasSubstr(path(name).string() + ": is in the place of a file")) << name;
    EXPECT_EQ(pictures(".exr"), 0u) << name;
    std::filesystem::remove_all(path("out"));
  }
}

TEST_F(GlRun, TheExitCodeDoesNotDependOnWhoReadsTheProgress) {
  const auto result = run_process(
      {.argv = {"/bin/bash", "-c", "\"$0\" run job.json --out out | head -1; echo ${PIPESTATUS[0]}",
                LIGHTBENCH_BINARY},
       .working_directory = path(""),
       .environment = environment_,
       .timeout = std::chrono::minutes(5)});
  EXPECT_THAT(result.out, HasSubstr("\n0\n")) << result.out << result.err;
}

TEST_F(GlRun, RetryingWithoutARunIsBadUsage) {
  const auto result = run_job({"--retry-failed"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("there is no run in this folder"));
  EXPECT_FALSE(std::filesystem::exists(path("out"))) << "nothing is begun";
}

TEST_F(GlRun, RetryingWhenNothingFailedJudgesAllGates) {
  write_job(R"(, "gates": [{"metric": "mean_error", "variant": "*", "max": 255}])");
  EXPECT_EQ(run_job().exit_code, 0);
  const auto result = run_job({"--retry-failed"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("The gate is met"));
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

TEST_F(GlRun, PicturesOfAnotherEngineAreScored) {
  add_pictures(188);  // the sRGB of what the fake POV-Ray shows
  EXPECT_EQ(run_job().exit_code, 0);
  const auto score = Json::parse(read_file(path("out/views/box/front/mine~truth.score.json")));
  EXPECT_EQ(score.at("metrics").at("mean_error"), 0.0);
  const Json stored = report();  // which the loop looks into
  for (const Json& image : stored.at("images"))
    if (image.at("source") == "mine") EXPECT_EQ(image.at("seconds"), 0) << "nobody knows what it cost";
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

TEST_F(GlRun, BenchTimesEveryVariantApart) {
  const auto result = run({"bench", "job.json", "--rounds", "2", "-o", "bench.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("box/front/lit"));
  const auto json = Json::parse(read_file(path("bench.json")));
  EXPECT_EQ(json.at("rows").size(), 4u);
  EXPECT_GT(json.at("rows").at(0).at("passes").at(0).at("median_seconds").get<double>(), 0);
}

TEST_F(GlRun, BenchLeavesPicturesOfAnotherEngineOut) {
  add_pictures(100);
  const auto result = run({"bench", "job.json", "--rounds", "1", "-o", "bench.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Json::parse(read_file(path("bench.json"))).at("rows").size(), 4u);
}

}  // namespace
}  // namespace lightbench
