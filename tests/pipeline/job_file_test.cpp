#include "pipeline/job_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "job_fixture.h"
#include "pipeline/plan.h"
#include "renderer/techniques/images.h"

namespace lightbench {
namespace {

using test::error_of;
using test::kJobText;
using test::replaced;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(JobFile, SaysWhatStandsInIt) {
  const Job job = parse_job(kJobText, "/jobs/job.json");
  EXPECT_EQ(job.name, "job");
  EXPECT_EQ(job.width, 8);
  EXPECT_EQ(job.scenes[0].file, "/jobs/one.json");
  EXPECT_EQ(views_of(job.scenes[0])[1].name, "b");
  EXPECT_EQ(job.variants[1].technique, "ambient");
  EXPECT_THAT(job.metrics, ElementsAre("mean_error", "gain"));
}

TEST(JobFile, MetricsOfFittedAmbientLightAreTakenOnRequest) {
  const auto text = replaced(kJobText, R"("gain"])", R"("gain", "over_ambient"])");
  const Job job = parse_job(text, "/jobs/job.json");
  EXPECT_THAT(job.metrics, ElementsAre("mean_error", "gain", "over_ambient"));
  // They need a buffer of the baseline, and of that alone.
  EXPECT_THAT(variant_buffers(job, job.variants[0]), ElementsAre("albedo"));
  EXPECT_THAT(variant_buffers(job, job.variants[1]), ElementsAre());
  const auto all = replaced(kJobText, R"(,
  "metrics": ["mean_error", "gain"])",
                            "");
  EXPECT_THAT(parse_job(all, "/jobs/job.json").metrics, testing::Not(testing::Contains("over_ambient")));
}

TEST(JobFile, DefaultsAreFilledIn) {
  const Job job = parse_job(kJobText, "/jobs/job.json");
  EXPECT_EQ(job.samples, 1);
  EXPECT_EQ(job.baseline, "direct");
  EXPECT_EQ(job.primary_reference, "truth");
  EXPECT_EQ(job.references[0].timeout, std::chrono::hours(2));
  EXPECT_EQ(reference_params(job.references[0]).integer("recursion_limit"), 2);
}

TEST(JobFile, TheNameIsTheFilesWhereNoneIsGiven) {
  EXPECT_EQ(parse_job(replaced(kJobText, R"("name": "job",)", ""), "/jobs/tuesday.json").name, "tuesday");
}

TEST(JobFile, TwoDirectVariantsLeaveNoBaseline) {
  const auto text = replaced(kJobText, R"("name": "other", "technique": "ambient")",
                             R"("name": "other", "technique": "direct", "preset": "pcf")");
  EXPECT_EQ(parse_job(text, "/jobs/job.json").baseline, "");
}

TEST(JobFile, CommentsAreAllowed) {
  EXPECT_EQ(error_of("// a job\n" + std::string(kJobText)), "no error");
}

TEST(JobFile, TheTextOfAJobReadsBackToTheSameJob) {
  const auto text =
      replaced(kJobText, R"("technique": "ambient")",
               R"("technique": "ambient", "params": {"shadows": "pcf"}, "sweep": {"k": [0.1, 0.7]})");
  const Job job = parse_job(text, "/jobs/job.json");
  const Job again = parse_job(job_text(job), "/elsewhere/job.json");
  EXPECT_EQ(job_text(again), job_text(job));
  EXPECT_EQ(views_of(again.scenes[0])[0].camera.fov, views_of(job.scenes[0])[0].camera.fov);
}

TEST(JobFile, NamedViewsOfACameraScriptAreKept) {
  const auto text = R"({"scenes": [{"scene": "s.json", "cameras": "c.json", "views": ["x", "y"]}],
                        "variants": [{"technique": "direct"}]})";
  const Job job = parse_job(text, "/jobs/job.json");
  const auto script = std::get<CameraScript>(job.scenes[0].views);
  EXPECT_EQ(script.file, "/jobs/c.json");
  EXPECT_THAT(script.names, ElementsAre("x", "y"));
}

struct BadJob {
  const char* what;
  const char* from;
  const char* to;
  const char* error;
};

void PrintTo(const BadJob& bad, std::ostream* stream) {
  *stream << bad.what;
}

class JobFileError : public ::testing::TestWithParam<BadJob> {};

TEST_P(JobFileError, NamesThePlaceAndTheNearestName) {
  EXPECT_THAT(error_of(replaced(kJobText, GetParam().from, GetParam().to)), HasSubstr(GetParam().error));
}

const BadJob kBadJobs[] = {
    {"unknown key", R"("metrics")", R"("metrix")", "$: unknown key 'metrix' (did you mean 'metrics'?)"},
    {"unknown metric", R"("gain"])", R"("gian"])", "$.metrics[1]: must be one of"},
    {"metric twice", R"("gain"])", R"("mean_error"])", "$.metrics[1]: the metric 'mean_error' stands twice"},
    {"unknown technique", R"("ambient")", R"("ambeint")", "$.variants[1].technique: "},
    {"nearest technique", R"("ambient")", R"("ambeint")", "did you mean 'ambient'?"},
    {"unknown preset", R"("technique": "direct")", R"("technique": "direct", "preset": "pfc")",
     "$.variants[0].preset: must be one of"},
    {"unknown parameter", R"("technique": "direct")",
     R"("technique": "direct", "params": {"shadow": "hard"})",
     "$.variants[0].params: unknown key 'shadow' (did you mean 'shadows'?)"},
    {"parameter out of range", R"("technique": "ambient")", R"("technique": "ambient", "params": {"k": -1})",
     "$.variants[1].params.k: 'k' must be between"},
    {"parameter of a wrong type", R"("technique": "ambient")",
     R"("technique": "ambient", "params": {"k": "1"})", "$.variants[1].params.k: 'k' must be a number"},
    {"parameter swept and given", R"("technique": "ambient")",
     R"("technique": "ambient", "params": {"k": 1}, "sweep": {"k": [1]})",
     "$.variants[1].sweep: 'k' stands in"},
    {"empty sweep", R"("technique": "ambient")", R"("technique": "ambient", "sweep": {"k": []})",
     "$.variants[1].sweep.k: a sweep needs at least one value"},
    {"huge sweep", R"("technique": "ambient")",
     R"("technique": "ambient", "sweep": {"k": [0,1,2,3,4,5,6,7], "pcf_radius": [0,1,2,3,4,5,6,7],
        "esm_blur_radius": [0,1,2,3,4,5,6,7], "esm_size": [16,17,18,19,20,21,22,23],
        "shadow_size": [16,17]})",
     "$.variants[1]: the sweep of 'other' makes "},
    {"name twice", R"("name": "other")", R"("name": "direct")",
     "$.variants[1]: the name 'direct' stands twice"},
    {"variant named as a reference", R"("name": "truth")", R"("name": "direct")",
     "$.references[0]: the name"},
    {"empty name", R"("name": "other")", R"("name": " ")", "$.variants[1].name: a name must not be empty"},
    {"name with a line break", R"("name": "other")", R"("name": "a\nb")", "control characters"},
    {"scene twice", R"("name": "two")", R"("name": "one")", "$.scenes[1]: the scene 'one' stands twice"},
    {"view twice", R"("name": "b")", R"("name": "a")", "$.scenes[0].views[1]: the view 'a' stands twice"},
    {"unknown kind", R"("kind": "povray")", R"("kind": "povary")",
     "$.references[0].kind: unknown reference kind"},
    {"bad timeout", R"("kind": "povray")", R"("kind": "povray", "timeout": 0)", "$.references[0].timeout"},
    {"zero-size image", "[8, 6]", "[0, 6]", "$.size"},
    {"image of 100k x 100k", "[8, 6]", "[100000, 100000]", "$.size"},
    {"too large with its samples", "[8, 6]", "[16384, 16384], \"samples\": 4", "$.samples"},
    {"size of three", "[8, 6]", "[8, 6, 1]", "$.size: must be [width, height]"},
    {"size in text", "[8, 6]", "[\"8\", 6]", "$.size[0]: must be a whole number, not a text"},
    {"zero-area camera", R"("position": [1, 0, 0])", R"("position": [0, 0, 0])", "$.scenes[1].views[0]"},
    {"foreign variable", "one.json", "${HOME}/one.json", "$.scenes[0].scene"},
    {"no variants", R"({"name": "direct", "technique": "direct"}, {"name": "other", "technique": "ambient"})",
     "", "$.variants: a job needs at least one variant"},
    {"unknown baseline", R"("metrics")", R"("baseline": "dierct", "metrics")", "did you mean 'direct'?"},
    {"unknown buffer", R"("metrics")", R"("buffers": ["albedoo"], "metrics")", "$.buffers[0]"},
    {"gate without bounds", R"("metrics")", R"("gates": [{"metric": "gain", "variant": "other"}], "metrics")",
     "$.gates[0]: a gate needs 'min' or 'max'"},
    {"gate of no variant", R"("metrics")",
     R"("gates": [{"metric": "gain", "variant": "othre", "min": 0}], "metrics")",
     "$.gates[0].variant: no variant is called 'othre' (did you mean 'other'?)"},
    {"gate of a metric that is not computed", R"("metrics")",
     R"("gates": [{"metric": "pearson", "variant": "other", "min": 0}], "metrics")",
     "$.gates[0].metric: the job does not compute 'pearson': name it in the job's 'metrics'"},
    {"gate with bounds the wrong way round", R"("metrics")",
     R"("gates": [{"metric": "gain", "variant": "*", "min": 2, "max": 1}], "metrics")",
     "'min' is above 'max'"},
    {"scale out of range", R"("metrics")", R"("difference": {"heat_scale": 0}, "metrics")",
     "$.difference.heat_scale"},
    {"cameras and random", R"("name": "two",)", R"("name": "two", "random": {"count": 1},)",
     "$.scenes[1]: needs"},
    {"random views of a generator that is not there",
     R"("views": [{"name": "a", "position": [1, 0, 0], "look_at": [0, 0, 0]}])",
     R"("random": {"count": 1, "version": 99})", "$.scenes[1].random.version: must be between 1 and"},
    {"view names without a script", R"([{"name": "a", "position": [1, 0, 0], "look_at": [0, 0, 0]}])",
     R"(["a"])", "$.scenes[1].views[0]: must be an object"},
    {"not JSON", R"("metrics")", R"(metrics)", "/jobs/job.json:11"},
};
INSTANTIATE_TEST_SUITE_P(All, JobFileError, ::testing::ValuesIn(kBadJobs));

TEST(JobFile, ANumberInATextIsCalledAText) {
  EXPECT_THAT(
      error_of(replaced(kJobText, R"("views": [{"name": "a", "position": [1, 0, 0], "look_at": [0, 0, 0]}])",
                        R"("random": {"count": 1, "seed": "1"})")),
      HasSubstr("$.scenes[1].random.seed: must be a whole number, not a text"));
}

TEST(JobFile, AJobWithASequenceHasTheMetricsOfSequences) {
  const std::string text = R"({"scenes": [{"scene": "s.json", "random": {"count": 1}SEQUENCE}],
                               "variants": [{"technique": "direct"}]})";
  const auto metrics_with = [&](const std::string& sequence) {
    return parse_job(replaced(text, "SEQUENCE", sequence), "/job.json").metrics;
  };
  EXPECT_THAT(metrics_with(""), testing::Not(testing::Contains("flicker")));
  EXPECT_THAT(metrics_with(R"(, "sequence": {"frames": 2, "rate": 12})"), testing::Contains("flicker"));
}

TEST(JobFile, ASequenceReadsBackFromItsText) {
  const auto job = parse_job(R"({"scenes": [{"scene": "s.json", "random": {"count": 1},
                                             "sequence": {"start": 0.1, "frames": 5, "rate": 24}}],
                                 "variants": [{"technique": "direct"}]})",
                             "/job.json");
  const auto again = parse_job(job_text(job), "/job.json");
  ASSERT_TRUE(again.scenes[0].sequence);
  EXPECT_EQ(again.scenes[0].sequence->start, 0.1);
  EXPECT_EQ(again.scenes[0].sequence->frames, 5);
  EXPECT_EQ(again.scenes[0].sequence->rate, 24);
}

TEST(JobFile, RandomViewsReadBackFromTheirText) {
  const auto version_of = [](const Job& job) {
    return std::get<RandomViewsRequest>(job.scenes[0].views).version;
  };
  const std::string text = R"({"scenes": [{"scene": "s.json", "random": {"count": 1VERSION}}],
                               "variants": [{"technique": "direct"}]})";
  const auto old = parse_job(replaced(text, "VERSION", R"(, "version": 1)"), "/job.json");
  EXPECT_EQ(version_of(old), 1);
  EXPECT_EQ(version_of(parse_job(job_text(old), "/job.json")), 1);
  EXPECT_EQ(version_of(parse_job(replaced(text, "VERSION", ""), "/job.json")), kNewestGenerator);
}

/// The job with a variant of technique images as a file in `folder`.
Job job_with_pictures(const std::string& folder, const std::string& pattern) {
  const std::string variant = R"({"technique": "images", "params": {"pattern": ")" + pattern + "\"}},";
  return parse_job(replaced(kJobText, R"("variants": [)", R"("variants": [)" + variant),
                   folder + "/job.json");
}

TEST(JobFile, PicturesAreLookedForInTheJobsFolder) {
  const Job job = job_with_pictures("/jobs", "renders/{scene}/{view}.png");
  EXPECT_EQ(std::get<std::string>(job.variants[0].params.at("pattern")), "/jobs/renders/{scene}/{view}.png");
}

TEST(JobFile, BracesAndDollarsOfTheJobsFolderMeanThemselves) {
  for (const char* folder : {"/a {scene} b", "/{x", "/x}", "/${HOME}", "/$${LIGHTBENCH_X}", "/a{{b"}) {
    const Job job = job_with_pictures(folder, "{view}.png");
    for (const Job& one : {job, parse_job(job_text(job), "/elsewhere/job.json")}) {
      const std::string pattern = std::get<std::string>(one.variants[0].params.at("pattern"));
      EXPECT_EQ(picture_path(pattern, "hall", "north"), std::string(folder) + "/north.png");
      EXPECT_EQ(one.scenes[0].file, std::string(folder) + "/one.json");
    }
  }
}

TEST(JobFile, APathCannotBeSwept) {
  EXPECT_THAT(
      error_of(replaced(kJobText, R"("variants": [)",
                        R"("variants": [{"technique": "images", "sweep": {"pattern": ["a", "b"]}},)")),
      HasSubstr("'pattern' is a path and cannot be swept"));
}

TEST(JobFile, ANameThatComesFromAFileIsCheckedToo) {
  const std::string nameless = replaced(kJobText, R"("name": "job",)", "");
  const auto error = [&](const std::string& file) {
    try {
      parse_job(nameless, file);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error("/jobs/" + std::string(200, 'x') + ".json"), "no error");
  EXPECT_THAT(error("/jobs/" + std::string(201, 'x') + ".json"),
              HasSubstr("the name is taken from the file's name, which must have at most 200 bytes"));
  EXPECT_THAT(error("/jobs/a\nb.json"), HasSubstr("control characters; give a"));
  EXPECT_THAT(error_of(replaced(kJobText, R"("name": "one", "scene": "one.json")",
                                R"("scene": ")" + std::string(201, 'x') + R"(.json")")),
              HasSubstr("$.scenes[0].scene: the name is taken from the file's name"));
}

TEST(JobFile, APatternOfAGateMatchesWhatASweepMakes) {
  const auto with_gate = [](const std::string& variant) {
    return error_of(
        replaced(replaced(kJobText, R"({"name": "other", "technique": "ambient"})",
                          R"({"name": "other", "technique": "ambient", "sweep": {"k": [0.25, 0.5]}})"),
                 R"("metrics")",
                 R"("gates": [{"metric": "gain", "variant": ")" + variant + R"(", "min": 1}], "metrics")"));
  };
  EXPECT_EQ(with_gate("other"), "no error") << "it stands for all that its sweep makes";
  EXPECT_EQ(with_gate("other*"), "no error");
  EXPECT_THAT(with_gate("oth?r"), HasSubstr("no variant is called 'oth?r'")) << "no variant has that name";
}

TEST(JobFile, TheLastFrameOfASequenceHasATimeThatViewsMayHave) {
  EXPECT_THAT(error_of(replaced(
                  kJobText, R"("scene": "one.json",)",
                  R"("scene": "one.json", "sequence": {"start": 500000, "frames": 600, "rate": 0.001},)")),
              HasSubstr("$.scenes[0].sequence: the last frame must be at most at 1000000 seconds"));
}

TEST(JobFile, NamesThatASweepMakesHaveNoControlCharacters) {
  EXPECT_THAT(error_of(replaced(kJobText, R"({"name": "other", "technique": "ambient"})",
                                R"({"technique": "surface_radiance", "sweep": {"sizes": ["a\nb", "c"]}})")),
              HasSubstr("a name that the sweep makes must not have control characters"));
}

TEST(JobFile, AViewsNameIsAName) {
  EXPECT_THAT(error_of(replaced(kJobText, R"("name": "a", "position")", R"("name": "a\tb", "position")")),
              HasSubstr("$.scenes[0].views[0].name: a name must not have control characters"));
}

TEST(JobFile, VariantsAreCountedWithTheirSweeps) {
  std::string variants, values = "0";
  for (int i = 1; i < 4000; ++i) values += ", " + std::to_string(i * 0.0001);
  for (int i = 0; i < 6; ++i)
    variants += R"({"name": "v)" + std::to_string(i) + R"(", "technique": "ambient", "sweep": {"k": [)" +
                values + "]}},";
  EXPECT_THAT(error_of(replaced(kJobText, R"("variants": [)", R"("variants": [)" + variants)),
              HasSubstr("$.variants[5]: a job has at most 20000 variants"));
}

TEST(JobFile, ASweepThatOverflowsItsCountIsRefused) {
  std::string values = "1";
  for (int i = 2; i <= 4096; ++i) values += ", " + std::to_string(i);
  std::string sweep;
  for (const char* name : {"shadow_size", "directional_shadow_size", "esm_size", "directional_esm_size"})
    sweep += std::string(sweep.empty() ? "" : ", ") + '"' + name + "\": [" +
             values.substr(values.find("16")) + "]";
  EXPECT_THAT(error_of(replaced(kJobText, R"("technique": "ambient")",
                                R"("technique": "ambient", "sweep": {)" + sweep + "}")),
              HasSubstr("variants; at most 4096 are possible"));
}

}  // namespace
}  // namespace lightbench
