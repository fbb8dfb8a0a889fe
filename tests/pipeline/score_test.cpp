#include "pipeline/score.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/image_io.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

class ScoreOfFiles : public ::testing::Test {
 protected:
  /// A 2x1 picture: its left pixel has `left` in all components, its right one 0.
  std::filesystem::path png(const std::string& name, std::uint8_t left, int channels = 3,
                            std::uint8_t alpha = 255) {
    Image8 image(2, 1, channels, 0);
    for (int c = 0; c < 3; ++c) image.pixel(0, 0)[std::size_t(c)] = left;
    if (channels == 4) image.pixel(0, 0)[3] = alpha;
    write_png(folder_.path() / name, image);
    return folder_.path() / name;
  }

  TemporaryFolder folder_;
};

TEST_F(ScoreOfFiles, MetricsAreThoseAskedFor) {
  const Score score =
      compute_score({.image = png("a.png", 10), .reference = png("b.png", 40), .metrics = {"mean_error"}});
  ASSERT_EQ(score.metrics.size(), 1u);
  EXPECT_DOUBLE_EQ(*score.metrics.at("mean_error").value, 15);  // 30 in one of two pixels
}

TEST_F(ScoreOfFiles, IdenticalPicturesAreKnownAsSuch) {
  EXPECT_TRUE(compute_score({.image = png("a.png", 40), .reference = png("b.png", 40)}).identical);
  EXPECT_FALSE(compute_score({.image = png("a.png", 41), .reference = png("b.png", 40)}).identical);
}

TEST_F(ScoreOfFiles, GainWithoutABaselineIsUndefined) {
  const Score score =
      compute_score({.image = png("a.png", 10), .reference = png("b.png", 40), .metrics = {"gain"}});
  EXPECT_FALSE(score.metrics.at("gain").value.has_value());
  EXPECT_THAT(score.metrics.at("gain").undefined_because, HasSubstr("no baseline"));
}

TEST_F(ScoreOfFiles, GainIsMeasuredAgainstTheBaseline) {
  const Score score = compute_score({.image = png("a.png", 30),
                                     .reference = png("b.png", 40),
                                     .baseline = png("c.png", 0),
                                     .metrics = {"gain"}});
  EXPECT_DOUBLE_EQ(*score.metrics.at("gain").value, 75);  // an error of 10 instead of 40
}

TEST_F(ScoreOfFiles, TheReferencesAlphaIsTheMask) {
  const auto reference = png("b.png", 40, 4);
  EXPECT_EQ(compute_score({.image = png("a.png", 10), .reference = reference}).masked_pixels, 1u);
  EXPECT_EQ(compute_score({.image = png("a.png", 10), .reference = reference, .use_reference_alpha = false})
                .masked_pixels,
            2u);
}

TEST_F(ScoreOfFiles, AMaskOfItsOwnCountsMore) {
  const Score score = compute_score(
      {.image = png("a.png", 10), .reference = png("b.png", 40, 4, 0), .mask = png("mask.png", 255)});
  EXPECT_EQ(score.masked_pixels, 1u);
}

TEST_F(ScoreOfFiles, OtherSizesAreAnErrorWithBothNames) {
  write_png(folder_.path() / "small.png", Image8(1, 1, 3));
  try {
    compute_score({.image = folder_.path() / "small.png", .reference = png("b.png", 40)});
    FAIL() << "the sizes were taken";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("small.png"));
    EXPECT_THAT(error.what(), HasSubstr("b.png"));
  }
}

TEST_F(ScoreOfFiles, UndefinedValuesHaveTheirReasonInTheJson) {
  Score score;
  score.metrics["gain"] = MetricValue::undefined("there is no baseline");
  score.metrics["mean_error"] = MetricValue::of(1.5);
  const auto json = nlohmann::json::parse(score_json(score));
  EXPECT_EQ(json["metrics"]["gain"]["undefined"], "there is no baseline");
  EXPECT_EQ(json["metrics"]["mean_error"], 1.5);
}

TEST_F(ScoreOfFiles, JsonHasThePlaceOfTheLargestErrorWhereItIsKnown) {
  Image8 a(20, 20, 3, 0), b = a;
  b.pixel(7, 3)[1] = 90;
  Score score;
  EXPECT_FALSE(nlohmann::json::parse(score_json(score)).contains("largest_error"));
  score.place = find_error(a, b);
  const auto json = nlohmann::json::parse(score_json(score));
  EXPECT_EQ(json["differing_pixels"], 1);
  EXPECT_EQ(json["largest_error"]["error"], 90);
  EXPECT_EQ(json["largest_error"]["x"], 7);
  EXPECT_EQ(json["largest_error"]["y"], 3);
  EXPECT_EQ(json["largest_error"]["region"]["pixels"], 1);
  EXPECT_EQ(json["worst_block"]["width"], 16);
}

TEST_F(ScoreOfFiles, FlickerIsMeasuredAgainstTheFrameBefore) {
  // Errors of 10 - 40 and 35 - 40: the left pixel changes by 25, and the right one not.
  const ScoreRequest request{.image = png("a.png", 10),
                             .reference = png("b.png", 40),
                             .previous_image = png("c.png", 35),
                             .previous_reference = png("d.png", 40),
                             .metrics = {"flicker"}};
  EXPECT_DOUBLE_EQ(*compute_score(request).metrics.at("flicker").value, 12.5);
}

TEST_F(ScoreOfFiles, FlickerLooksAtWhatIsAnObjectInBothFrames) {
  const ScoreRequest request{.image = png("a.png", 10),
                             .reference = png("b.png", 40),
                             .previous_image = png("c.png", 35),
                             .previous_reference = png("d.png", 40, 4),
                             .metrics = {"flicker"}};
  EXPECT_DOUBLE_EQ(*compute_score(request).metrics.at("flicker").value, 25) << "the left pixel alone";
}

TEST_F(ScoreOfFiles, AFrameBeforeThatHoldsNanIsAnError) {
  write_exr(folder_.path() / "nan.exr", Image(2, 1, 3, std::nanf("")), PixelType::half);
  const ScoreRequest request{.image = png("a.png", 10),
                             .reference = png("b.png", 40),
                             .previous_image = folder_.path() / "nan.exr",
                             .previous_reference = png("d.png", 40),
                             .metrics = {"flicker"}};
  try {
    compute_score(request);
    FAIL() << "NaN was taken";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("nan.exr"));
  }
}

}  // namespace
}  // namespace lightbench
