// Jobs with technique surface_radiance, which bakes what it draws.
#include "baked_fixture.h"
#include "reports/run_report.h"

namespace lightbench {
namespace {

using test::GlBaked;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class GlBakedRun : public GlBaked {
 protected:
  GlBakedRun() {
    write("job.json", R"({"name": "job", "size": [32, 24],
      "scenes": [{"name": "box", "scene": "scene.json", "cameras": "cameras.json"}],
      "variants": [)" + variant("raw") +
                          "," + variant("piecewise") + "," + variant("pca") + R"(],
      "references": [{"name": "truth", "kind": "path_tracer", "params": {"bounces": 0, "samples": 2}}],
      "metrics": ["mean_error"]})");
  }

  /// Baked as the fixture bakes.
  static std::string variant(const std::string& codec) {
    return R"({"name": ")" + codec +
           R"(", "technique": "surface_radiance", "params": {"density": 2, "thetas": 3, "phis": 4, "codec": ")" +
           codec + "\"}}";
  }

  ProcessResult run_job(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", "job.json", "--out", "out"});
    return run(more);
  }
  std::size_t files_called(const std::string& ending) const {
    std::size_t count = 0;
    for (const auto& file : files("out")) count += file.ends_with(ending);
    return count;
  }
};

TEST_F(GlBakedRun, DrawsAllCodecsFromOneBake) {
  const auto result = run_job();
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_EQ(files_called(".mtex"), 2u) << "one for each object";
  EXPECT_EQ(files_called("front/raw.png") + files_called("side/pca.png"), 2u);
  // Both codecs are bounded by a few of 255.
  EXPECT_LT(mean_difference("out/views/box/front/raw.exr", "out/views/box/front/piecewise.exr"), 3);
  EXPECT_LT(mean_difference("out/views/box/front/raw.exr", "out/views/box/front/pca.exr"), 3);
}

TEST_F(GlBakedRun, TheReportTellsWhatEachObjectCost) {
  run_job();
  const RunReport report = run_report_from_json(read_file(path("out/run.json")), "run.json");
  ASSERT_EQ(report.bakes.size(), 2u);
  EXPECT_THAT(report.bakes[0].variants, ElementsAre("raw", "piecewise", "pca"));
  EXPECT_GT(report.bakes[0].cpu_seconds, 0);
  EXPECT_EQ(report.bakes[0].numbers.at("directions"), MetricValue::of(12));
  ASSERT_EQ(report.compressions.size(), 4u);
  for (const ReportObject& object : report.compressions) {
    const auto number = [&](const std::string& name) { return object.numbers.at(name).value.value_or(0); };
    EXPECT_GT(number("texels"), 0) << object.object;
    EXPECT_EQ(number("raw_bytes"), 3 * 12 * number("texels")) << object.object;
    EXPECT_GT(number("ratio"), 0) << object.object;
  }
}

TEST_F(GlBakedRun, ASecondRunDoesNothing) {
  run_job();
  const auto result = run_job();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  // For three variants of two views: 2 bakes, 2 x 2 compressions, 6 snapshots, 2 references and 6 scores.
  EXPECT_THAT(result.out, HasSubstr("0 tasks to do, 20 there already"));
}

TEST_F(GlBakedRun, StageBakeBakesAlone) {
  const auto result = run_job({"--stages", "bake"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_EQ(files_called(".mtex"), 2u);
  EXPECT_EQ(files_called(".png"), 0u);
  EXPECT_THAT(run_job().out, HasSubstr("18 tasks to do, 2 there already"));
}

TEST_F(GlBakedRun, ABakeThatWasDamagedIsMadeAgain) {
  run_job();
  for (const auto& file : files("out"))
    if (file.ends_with("0000-box.mtex")) std::filesystem::resize_file(path(file), 100);
  EXPECT_THAT(run_job().out, HasSubstr("1 task to do, 19 there already"));
}

TEST_F(GlBakedRun, CommandsBakeAndRenderMakeTheSamePicture) {
  run_job({"--only", "box/front/raw"});
  bake();
  draw("alone.exr");
  EXPECT_EQ(read_image_srgb8(path("out/views/box/front/raw.exr")), read_image_srgb8(path("alone.exr")));
}

}  // namespace
}  // namespace lightbench
