// Single pictures: commands render and reference.
#include "e2e_fixture.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

class GlRender : public test::Program {};

TEST_F(GlRender, WritesThePictureAndItsBuffers) {
  const auto result = run({"render", "scene.json", "--cameras", "cameras.json", "--view", "side", "--size",
                           "32x24", "-o", "a.png", "--buffers", "albedo,depth"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_image_srgb8(path("a.png")).width, 32);
  EXPECT_TRUE(std::filesystem::exists(path("a.albedo.exr")));
  EXPECT_TRUE(std::filesystem::exists(path("a.depth.png")));
}

TEST_F(GlRender, TakesOptionsSeveralTimesAndBeforeTheScene) {
  const auto result = run({"render",
                           "-p",
                           "shadows=none",
                           "-p",
                           "shadow_size=64",
                           "--buffers",
                           "albedo,depth",
                           "--position",
                           "-1",
                           "2",
                           "4",
                           "--look-at",
                           "0",
                           "0",
                           "0",
                           "--size",
                           "32x24",
                           "scene.json",
                           "-o",
                           "a.png"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(path("a.depth.exr")));
}

TEST_F(GlRender, UnwritableOutputIsAnError) {
  const auto result =
      run({"render", "scene.json", "--cameras", "cameras.json", "--size", "32x24", "-o", "/proc/a.png"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("/proc/a.png"));
}

TEST_F(GlRender, NeverOverwritesWhatItReads) {
  const std::string before = read_file(path("box.mtl"));
  write("box.mtl", before + "map_Kd box.albedo.png\n");
  write_png(path("box.albedo.png"), Image8(4, 4, 3, 128));
  const std::string texture = read_file(path("box.albedo.png"));
  for (const std::vector<std::string>& output :
       {std::vector<std::string>{"-o", "./box.albedo.png"}, {"-o", "box.png", "--buffers", "albedo"}}) {
    std::vector<std::string> arguments = {"render",       "scene.json", "--cameras",
                                          "cameras.json", "--size",     "32x24"};
    arguments.insert(arguments.end(), output.begin(), output.end());
    const auto result = run(arguments);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr("a file of the scene would be overwritten by"));
    EXPECT_EQ(read_file(path("box.albedo.png")), texture);
  }
}

TEST_F(GlRender, LightBeyondHalfFloatsIsClampedWithAWarning) {
  write("box.mtl", "newmtl grey\nKd 0.6 0.5 0.4\nKe 1e6 1 1\n");
  const auto result =
      run({"render", "scene.json", "--cameras", "cameras.json", "--size", "32x24", "-o", "a.exr"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("beyond 65504"));
  EXPECT_EQ(read_image(path("a.exr")).pixel(16, 12)[0], kLargestHalf);
}

class PovrayRun : public test::Program {};

TEST_F(PovrayRun, DirectLightAgreesWithPovray) {
  write("job.json", R"({"size": [64, 48], "scenes": [{"scene": "scene.json", "cameras": "cameras.json"}],
      "variants": [{"name": "direct", "technique": "direct"}],
      "references": [{"name": "truth", "kind": "povray", "preset": "direct"}],
      "metrics": ["mean_error"], "gates": [{"metric": "mean_error", "variant": "direct", "max": 0.5}]})");
  const auto result = run({"run", "job.json", "--out", "out"});
  // Both round to 8 bits, and edges of shadows may differ by a texel.
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST_F(PovrayRun, ASecondRenderingTellsHowExactTheFirstOneIs) {
  write("job.json", R"({"size": [32, 24],
      "scenes": [{"scene": "scene.json", "cameras": "cameras.json", "views": ["front"]}],
      "variants": [{"name": "direct", "technique": "direct"}],
      "references": [{"name": "truth", "kind": "povray", "params": {"estimate_noise": true, "count": 20}}]})");
  const auto result = run({"run", "job.json", "--out", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, ::testing::HasSubstr("noise of truth: "));
  EXPECT_TRUE(std::filesystem::exists(path("out/views/scene/front/truth~~second.pov")));
}

TEST_F(PovrayRun, AReferenceCanBeRenderedAlone) {
  const auto result = run({"reference", "scene.json", "--cameras", "cameras.json", "--size", "32x24",
                           "--preset", "direct", "-o", "truth.exr"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_image(path("truth.exr")).channels, 4);
}

}  // namespace
}  // namespace lightbench
