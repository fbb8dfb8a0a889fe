#include "run_fixture.h"

namespace lightbench {
namespace {

using test::GlRun;
using ::testing::HasSubstr;
using Json = nlohmann::json;

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
