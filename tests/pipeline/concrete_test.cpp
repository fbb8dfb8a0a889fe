#include "pipeline/concrete.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "job_fixture.h"
#include "pipeline/tables.h"
#include "scene/camera_script.h"

namespace lightbench {
namespace {

using test::kJobText;
using test::replaced;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Job swept_job(const std::string& gate_variant = "other") {
  auto text = replaced(kJobText, R"("technique": "ambient")",
                       R"("technique": "ambient", "sweep": {"shadows": ["hard", "pcf"], "k": [0.5, 1]})");
  text =
      replaced(text, R"("metrics")",
               R"("gates": [{"metric": "gain", "variant": ")" + gate_variant + R"(", "min": 0}], "metrics")");
  return test::concrete_job(text);
}

TEST(Concrete, ASweepMakesAVariantOfEachCombination) {
  EXPECT_THAT(row_names(swept_job().variants),
              ElementsAre("direct", "other[shadows=hard,k=0.5]", "other[shadows=hard,k=1]",
                          "other[shadows=pcf,k=0.5]", "other[shadows=pcf,k=1]"));
}

TEST(Concrete, ASweepOfMoreCombinationsThanCanBeCountedIsAnError) {
  JobVariant variant;
  for (int i = 0; i < 32; ++i)  // 4^32 is 2^64, which is 0 in 64 bits
    variant.sweep.emplace_back("p" + std::to_string(i), std::vector<ParamValue>{0.0, 1.0, 2.0, 3.0});
  EXPECT_THROW(expand_sweeps({variant}), Error);
}

TEST(Concrete, SweptVariantsHaveTheirValues) {
  const auto params = variant_params(swept_job().variants[2]);
  EXPECT_EQ(params.text("shadows"), "hard");
  EXPECT_EQ(params.number("k"), 1.0);
}

TEST(Concrete, AGateOfASweptVariantHoldsForAllThatItMakes) {
  const Job job = swept_job();
  ASSERT_EQ(job.gates.size(), 4u);
  EXPECT_EQ(job.gates[0].variant, "other[shadows=hard,k=0.5]");
  EXPECT_EQ(job.gates[3].variant, "other[shadows=pcf,k=1]");
}

TEST(Concrete, AGateOfAPatternStays) {
  const Job job = swept_job("oth*");
  ASSERT_EQ(job.gates.size(), 1u);
  EXPECT_EQ(job.gates[0].variant, "oth*");
}

TEST(Concrete, DrawnViewsAreStoredAndReadBack) {
  const TemporaryFolder out;
  const auto text =
      replaced(kJobText, R"("views": [{"name": "a", "position": [1, 0, 0], "look_at": [0, 0, 0]}])",
               R"("random": {"count": 1, "seed": 5, "fov": 40, "version": 1})");
  const Job job = make_concrete(parse_job(text, "/jobs/job.json"), out.path(),
                                [](const JobScene& scene, const RandomViewsRequest& request, double aspect) {
                                  EXPECT_EQ(scene.name, "two");
                                  EXPECT_EQ(request.seed, 5u);
                                  EXPECT_EQ(request.version, 1);
                                  EXPECT_DOUBLE_EQ(aspect, 8.0 / 6.0);
                                  return std::vector<View>{{"drawn", {{0.1f, 0.2f, 0.3f}, {0, 0, 0}}}};
                                });
  EXPECT_EQ(views_of(job.scenes[1])[0].name, "drawn");
  const auto stored = read_camera_script(out.path() / "cameras" / "two.json");
  EXPECT_EQ(stored[0].camera.position, views_of(job.scenes[1])[0].camera.position);
  EXPECT_THAT(read_file(out.path() / "cameras" / "two.json"),
              HasSubstr(R"("drawn": {"seed": 5, "version": 1})"));
}

/// The job with a gate on the views that match.
std::string with_view_gate(const std::string& view, const std::string& more = "",
                           const std::string& text = kJobText) {
  return replaced(text, R"("metrics")",
                  R"("gates": [{"metric": "gain", "variant": "other", "min": 0, "view": ")" + view + "\"" +
                      more + R"(}], "metrics")");
}

std::string concrete_error(const std::string& text, const DrawViews& draw_views = nullptr,
                           const std::filesystem::path& out = "/out") {
  try {
    make_concrete(parse_job(text, "/jobs/job.json"), out, draw_views);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Concrete, AGateThatMatchesNoViewIsAnErrorWithItsPlace) {
  EXPECT_EQ(concrete_error(with_view_gate("[ab]")), "no error");
  EXPECT_EQ(concrete_error(with_view_gate("bb")), "/jobs/job.json: $.gates[0].view: no view is called 'bb'");
  EXPECT_THAT(concrete_error(with_view_gate("c*")), HasSubstr("no view is called 'c*'"));
}

TEST(Concrete, AGateLooksForViewsInItsScenesAlone) {
  EXPECT_EQ(concrete_error(with_view_gate("b", R"(, "scene": "one")")), "no error");
  EXPECT_THAT(concrete_error(with_view_gate("b", R"(, "scene": "two")")),
              HasSubstr("$.gates[0].view: no view of scene 'two' is called 'b'"));
}

TEST(Concrete, AGateOfASweptVariantIsComplainedOfOnce) {
  const auto text = replaced(with_view_gate("x"), R"("technique": "ambient")",
                             R"("technique": "ambient", "sweep": {"k": [0.5, 1]})");
  EXPECT_THAT(concrete_error(text), testing::StartsWith("/jobs/job.json: $.gates[0].view: no view"));
}

TEST(Concrete, AGateOnDrawnViewsIsCheckedOnceTheyAreDrawn) {
  const TemporaryFolder out;
  const auto drawn =
      replaced(kJobText, R"("views": [{"name": "a", "position": [1, 0, 0], "look_at": [0, 0, 0]}])",
               R"("random": {"count": 1})");
  const DrawViews draw = [](const JobScene&, const RandomViewsRequest&, double) {
    return std::vector<View>{{"drawn", {{0.1f, 0.2f, 0.3f}, {0, 0, 0}}}};
  };
  EXPECT_EQ(concrete_error(with_view_gate("drawn", "", drawn), draw, out.path()), "no error");
  EXPECT_THAT(concrete_error(with_view_gate("drwan", "", drawn), draw, out.path()),
              HasSubstr("$.gates[0].view: no view is called 'drwan' (did you mean 'drawn'?)"));
}

TEST(Concrete, NothingIsDrawnForAGateThatCannotMatch) {
  const auto drawn =
      replaced(kJobText, R"("views": [{"name": "a", "position": [1, 0, 0], "look_at": [0, 0, 0]}])",
               R"("random": {"count": 1})");
  const DrawViews never = [](const JobScene&, const RandomViewsRequest&, double) {
    ADD_FAILURE() << "views were drawn";
    return std::vector<View>();
  };
  EXPECT_THAT(concrete_error(with_view_gate("x", R"(, "scene": "one")", drawn), never),
              HasSubstr("no view of scene 'one' is called 'x'"));
}

TEST(Concrete, AllScriptsThatCannotBeReadAreNamed) {
  const std::string text = R"({"scenes": [{"name": "1", "scene": "s.json", "cameras": "none.json"},
                                          {"name": "2", "scene": "s.json", "cameras": "gone.json"}],
                               "variants": [{"technique": "direct"}]})";
  EXPECT_THAT(concrete_error(text), testing::AllOf(HasSubstr("2 problems"), HasSubstr("/jobs/none.json"),
                                                   HasSubstr("/jobs/gone.json")));
}

TEST(Concrete, NamedViewsAreTakenInTheOrderOfTheJob) {
  const TemporaryFolder folder;
  write_file_atomic(folder.path() / "c.json",
                    camera_script_text({{"x", {{1, 0, 0}}}, {"y", {{2, 0, 0}}}, {"z", {{3, 0, 0}}}}));
  const auto job_of = [&](const std::string& names) {
    return make_concrete(parse_job(R"({"scenes": [{"scene": "s.json", "cameras": "c.json", "views": )" +
                                       names + R"(}], "variants": [{"technique": "direct"}]})",
                                   folder.path() / "job.json"),
                         "/out", nullptr);
  };
  EXPECT_THAT(row_names(views_of(job_of(R"(["z", "x"])").scenes[0])), ElementsAre("z", "x"));
  try {
    job_of(R"(["w"])");
    FAIL() << "a view that is not there was found";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("c.json: has no view 'w'"));
  }
}

Job sequence_job(const std::string& scene_keys = "",
                 const std::string& sequence = R"({"start": 1, "frames": 3, "rate": 2})") {
  return test::concrete_job(replaced(kJobText, R"("scene": "one.json",)",
                                     R"("scene": "one.json", "sequence": )" + sequence + "," + scene_keys));
}

TEST(Concrete, ASequenceMakesFramesOfEachView) {
  const Job job = sequence_job();
  EXPECT_THAT(row_names(views_of(job.scenes[0])),
              ElementsAre("a.000", "a.001", "a.002", "b.000", "b.001", "b.002"));
  EXPECT_THAT(row_names(views_of(job.scenes[1])), ElementsAre("a")) << "of a scene without a sequence";
  const View& last = views_of(job.scenes[0])[5];
  EXPECT_EQ(last.time, 2);
  EXPECT_EQ(last.frame->sequence, "b");
  EXPECT_EQ(last.frame->number, 2);
}

TEST(Concrete, FramesHaveTheCameraOfTheirTimeAndMoveNoMore) {
  const Job job = test::concrete_job(R"({"scenes": [{"scene": "s.json", "sequence": {"frames": 3, "rate": 1},
      "views": [{"name": "a", "look_at": [0, 0, 0], "keyframes": [{"time": 0, "position": [0, 0, 2]},
                                                                 {"time": 2, "position": [0, 0, 6]}]}]}],
      "variants": [{"technique": "direct"}]})");
  const auto& views = views_of(job.scenes[0]);
  EXPECT_EQ(views[0].camera.position, glm::vec3(0, 0, 2));
  EXPECT_EQ(views[1].camera.position, glm::vec3(0, 0, 4));
  EXPECT_THAT(views[1].keyframes, testing::IsEmpty());
}

TEST(Concrete, ACameraThatIsNotPossibleInAFrameIsAnErrorWithItsPlace) {
  try {
    test::concrete_job(R"({"scenes": [{"scene": "s.json", "sequence": {"frames": 3, "rate": 1},
        "views": [{"name": "a", "look_at": [0, 0, 0], "keyframes": [{"time": 0, "position": [0, 0, 2]},
                                                                   {"time": 2, "position": [0, 0, -2]}]}]}],
        "variants": [{"technique": "direct"}]})");
    FAIL() << "the camera stands at its look_at";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("job.json: $.scenes[0].views[0]"));
    EXPECT_THAT(error.what(), HasSubstr("at 1 s"));
  }
}

TEST(Concrete, AFrameIsNotMadeASequence) {
  EXPECT_THROW(test::concrete_job(R"({"scenes": [{"scene": "s.json", "sequence": {"frames": 3, "rate": 1},
        "views": [{"name": "a", "position": [0, 0, 1], "look_at": [0, 0, 0], "frame": {"of": "walk", "number": 0}}]}],
        "variants": [{"technique": "direct"}]})"),
               Error);
}

TEST(Concrete, TheFrameBeforeIsThatOfTheSameSequence) {
  const auto views = views_of(sequence_job().scenes[0]);
  EXPECT_EQ(previous_frame(views, 0), std::nullopt);
  EXPECT_EQ(previous_frame(views, 2), 1u);
  EXPECT_EQ(previous_frame(views, 3), std::nullopt) << "the first of another sequence";
  EXPECT_EQ(previous_frame({{"still", {}}, {"still too", {}}}, 1), std::nullopt);
}

}  // namespace
}  // namespace lightbench
