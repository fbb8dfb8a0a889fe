#include "run_fixture.h"

namespace lightbench {
namespace {

using test::GlRun;
using ::testing::HasSubstr;
using Json = nlohmann::json;

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

TEST_F(GlPathTracedRun, AVariantLikeTheReferenceHasAnotherSeed) {
  // A floor and a wall, which light each other: the pictures have noise.
  write("box.obj",
        "mtllib box.mtl\nusemtl grey\nv -2 0 -2\nv 2 0 -2\nv 2 0 2\nv -2 0 2\nv -2 3 -2\nv 2 3 -2\n"
        "f 1 4 3 2\nf 1 2 6 5\n");
  const std::string job = R"({"size": [32, 24],
      "scenes": [{"name": "box", "scene": "scene.json", "cameras": "cameras.json"}],
      "variants": [{"name": "direct", "technique": "direct"},
                   {"name": "again", "technique": "path_tracer", "params": {"samples": 4 MORE}}],
      "references": [{"name": "truth", "kind": "path_tracer", "params": {"samples": 4}}],
      "metrics": ["mean_error", "gain"]})";
  const auto with = [&](const std::string& more) {
    std::string text = job;
    write("job.json", text.replace(text.find("MORE"), 4, more));
    EXPECT_EQ(run_job().exit_code, 0);
    return report().at("scores").at(1);
  };
  const Json apart = with("");
  EXPECT_EQ(apart.at("variant"), "again");
  EXPECT_GT(apart.at("metrics").at("mean_error").get<double>(), 0);
  EXPECT_FALSE(apart.contains("warnings"));
  const Json same = with(R"(, "seed": 1)");
  EXPECT_EQ(same.at("metrics").at("mean_error").get<double>(), 0);
  EXPECT_THAT(same.at("warnings").at(0).get<std::string>(), HasSubstr("are identical"));
  EXPECT_THAT(read_file(path("out/summary.md")), ::testing::Not(HasSubstr(" / "))) << "that is no ceiling";
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

}  // namespace
}  // namespace lightbench
