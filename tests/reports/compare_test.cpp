#include "reports/compare.h"

#include <cmath>
#include <limits>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/color.h"
#include "base/error.h"
#include "base/files.h"
#include "base/image_io.h"
#include "base/process.h"
#include "reports/difference_image.h"
#include "tests/reports/metric_pair.h"

namespace lightbench {
namespace {

using test::pattern;
using test::row_of;
using testing::AllOf;
using testing::HasSubstr;

class Compare : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

  std::filesystem::path png(const std::string& name, const Image8& image) const {
    write_png(file(name), image);
    return file(name);
  }

  std::filesystem::path exr(const std::string& name, const Image& image) const {
    write_exr(file(name), image, PixelType::float32);
    return file(name);
  }

  double value(const CompareOptions& options, const std::string& metric) const {
    CompareOptions one = options;
    one.metrics = {metric};
    return compare_files(one).metrics.front().second.value.value_or(std::nan(""));
  }

  std::string error(const CompareOptions& options) const {
    try {
      compare_files(options);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

 private:
  TemporaryFolder folder_;
};

/// The part in parentheses of ImageMagick's answer ("1234.5 (0.0188)"): the error with 1 for white.
double imagemagick(const std::string& metric, const std::filesystem::path& a,
                   const std::filesystem::path& b) {
  const ProcessResult result = run_process({.argv = {"compare", "-metric", metric, a, b, "null:"},
                                            .working_directory = {},
                                            .environment = {},
                                            .timeout = std::chrono::minutes(1)});
  const std::size_t open = result.err.find('(');
  return open == std::string::npos ? std::nan("") : std::stod(result.err.substr(open + 1));
}

TEST_F(Compare, AgreesWithImageMagickOnARealPair) {
  ASSERT_FALSE(find_program("compare").empty()) << "this test needs ImageMagick";
  const Image8 a = pattern(211, 97, 1);
  Image8 b = pattern(211, 97, 2);
  for (std::size_t i = 0; i < b.data.size(); ++i) b.data[i] = std::uint8_t((3 * a.data[i] + b.data[i]) / 4);
  const CompareOptions pair{.reference = png("a.png", a), .image = png("b.png", b)};
  // ImageMagick prints six digits.
  EXPECT_NEAR(value(pair, "mean_error"), 255 * imagemagick("MAE", pair.reference, pair.image), 2e-4);
  EXPECT_NEAR(value(pair, "rmse"), 255 * imagemagick("RMSE", pair.reference, pair.image), 2e-4);
}

TEST_F(Compare, ChoosesAllMetricsThatNeedNoBaseline) {
  const CompareResult result =
      compare_files({.reference = png("a.png", pattern(8, 6, 1)), .image = png("b.png", pattern(8, 6, 2))});
  EXPECT_EQ(result.width, 8);
  EXPECT_EQ(result.height, 6);
  std::vector<std::string> names;
  for (const auto& [name, value] : result.metrics) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"mean_error", "pearson", "luv", "luminance_error", "rmse",
                                             "max_error", "p99_error", "bad_pixels", "block_error"}));
}

TEST_F(Compare, TellsTheFirstPlaceOfTheLargestError) {
  const Image8 a(30, 20, 3, 100);
  Image8 b = a;
  b.pixel(21, 7)[1] = 160;
  const CompareResult result = compare_files({.reference = png("a.png", a), .image = png("b.png", b)});
  ASSERT_TRUE(result.place);
  EXPECT_EQ(result.place->x, 21);
  EXPECT_EQ(result.place->y, 7);
}

TEST_F(Compare, TellsNoPlaceOfIdenticalPictures) {
  const auto a = png("a.png", pattern(8, 6, 1));
  EXPECT_FALSE(compare_files({.reference = a, .image = a}).place);
}

TEST_F(Compare, TakesABaseline) {
  const CompareOptions options{.reference = png("a.png", row_of({{100, 100, 100}})),
                               .image = png("b.png", row_of({{95, 100, 100}})),
                               .baseline = png("c.png", row_of({{80, 100, 100}}))};
  EXPECT_EQ(value(options, "gain"), 75);
}

TEST_F(Compare, FloatFilesAreRoundedToSrgb) {
  const Image8 image = pattern(16, 16, 3);
  const CompareOptions options{.reference = png("a.png", image), .image = exr("b.exr", from_srgb8(image))};
  EXPECT_EQ(value(options, "mean_error"), 0);
}

TEST_F(Compare, MaskIsTheReferencesAlpha) {
  Image reference(2, 1, 4, 0.0f);
  reference.pixel(0, 0)[3] = 1;
  const CompareOptions options{.reference = exr("a.exr", reference),
                               .image = png("b.png", row_of({{255, 255, 255}, {0, 0, 0}}))};
  EXPECT_NEAR(value(options, "luv"), 100, 1e-4);
  const CompareResult result = compare_files(options);
  EXPECT_EQ(result.mask_pixels, 1u);
  EXPECT_THAT(result.mask_source, AllOf(HasSubstr("alpha of"), HasSubstr("a.exr")));
}

TEST_F(Compare, TellsOfAlphaThatDiffers) {
  Image opaque(2, 1, 4, 0.5f), clear = opaque;
  for (int x = 0; x < 2; ++x) opaque.pixel(x, 0)[3] = 1;
  clear.pixel(0, 0)[3] = 1, clear.pixel(1, 0)[3] = 0.2f;
  const CompareOptions options{.reference = exr("a.exr", opaque), .image = exr("b.exr", clear)};
  EXPECT_EQ(value(options, "mean_error"), 0) << "seen over black they are the same";
  EXPECT_EQ(compare_files(options).alpha, (AlphaDifference{.pixels = 1, .largest = 204}));
  const auto plain = exr("c.exr", first_channels(opaque, 3));
  EXPECT_EQ(compare_files({.reference = options.reference, .image = plain}).alpha, AlphaDifference());
  EXPECT_EQ(compare_files({.reference = plain, .image = options.image}).alpha.pixels, 1u);
}

TEST_F(Compare, SeesColourOverBlack) {
  Image8 opaque(2, 1, 4, 255), clear = opaque;
  clear.pixel(1, 0)[3] = 0;
  const CompareOptions options{.reference = png("a.png", opaque), .image = png("b.png", clear)};
  EXPECT_EQ(value(options, "mean_error"), 127.5);
  EXPECT_EQ(compare_files(options).alpha.pixels, 1u);
}

/// A file whose layers `one` and `two` are of a grey each.
void write_layers(const std::filesystem::path& file, float one, float two) {
  OIIO::ImageSpec spec(2, 1, 2, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"one.Y", "two.Y"};
  const float pixels[] = {one, two, one, two};
  auto output = OIIO::ImageOutput::create("openexr");
  ASSERT_TRUE(output->open(file.string(), spec) && output->write_image(OIIO::TypeDesc::FLOAT, pixels) &&
              output->close());
}

TEST_F(Compare, ReadsTheLayersThatAreNamed) {
  write_layers(file("a.exr"), 0, 1);
  write_layers(file("b.exr"), 1, 0);
  CompareOptions options{.reference = file("a.exr"), .image = file("b.exr")};
  EXPECT_THAT(error(options), AllOf(HasSubstr("'one', 'two'"), HasSubstr("a.exr")));
  options.layer = "one";
  EXPECT_EQ(value(options, "mean_error"), 255);
  options.reference_layer = "two";
  EXPECT_EQ(value(options, "mean_error"), 0);
  options.reference = png("white.png", row_of({{255, 255, 255}, {255, 255, 255}}));
  EXPECT_EQ(value(options, "mean_error"), 0) << "a file without layers is its picture";
}

TEST_F(Compare, AMaskFileCountsWhereItIsNotBlack) {
  const CompareOptions options{.reference = png("a.png", row_of({{0, 0, 0}, {0, 0, 0}})),
                               .image = png("b.png", row_of({{255, 255, 255}, {0, 0, 0}})),
                               .mask = png("m.png", row_of({{0, 0, 0}, {0, 0, 1}}))};
  EXPECT_EQ(value(options, "luv"), 0);
  EXPECT_EQ(compare_files(options).mask_source, options.mask.string());
}

TEST_F(Compare, EverythingCountsWithoutAMask) {
  const CompareResult result =
      compare_files({.reference = png("a.png", pattern(4, 3, 1)), .image = png("b.png", pattern(4, 3, 2))});
  EXPECT_EQ(result.mask_source, "all pixels");
  EXPECT_EQ(result.mask_pixels, 12u);
}

TEST_F(Compare, WritesDifferenceAndHeatMap) {
  const Image8 a = pattern(40, 30, 1), b = pattern(40, 30, 2);
  compare_files({.reference = png("a.png", a),
                 .image = png("b.png", b),
                 .difference = file("out/d.png"),
                 .heat = file("out/h.png"),
                 .heat_scale = 32});
  EXPECT_EQ(read_image_srgb8(file("out/d.png")), difference_image(a, b));
  EXPECT_EQ(read_image_srgb8(file("out/h.png")), heat_map(a, b, 32));
}

TEST_F(Compare, DifferentSizesAreNamedWithTheirFiles) {
  const CompareOptions options{.reference = png("a.png", pattern(4, 3, 1)),
                               .image = png("b.png", pattern(3, 4, 2)),
                               .difference = file("d.png")};
  EXPECT_THAT(error(options), AllOf(HasSubstr("a.png is 4x3"), HasSubstr("b.png is 3x4")));
  EXPECT_FALSE(std::filesystem::exists(options.difference));
}

TEST_F(Compare, AMaskOfAnotherSizeIsAnError) {
  const auto a = png("a.png", pattern(4, 3, 1));
  EXPECT_THAT(error({.reference = a, .image = a, .mask = png("m.png", pattern(3, 4, 2))}),
              AllOf(HasSubstr("m.png"), HasSubstr("mask")));
}

TEST_F(Compare, NotANumberIsAnErrorOfItsOwn) {
  Image broken(2, 2, 3, 0.5f);
  broken.data[4] = std::numeric_limits<float>::quiet_NaN();
  const auto good = png("a.png", pattern(2, 2, 1));
  EXPECT_THAT(error({.reference = good, .image = exr("nan.exr", broken)}), HasSubstr("nan.exr"));
}

TEST_F(Compare, MissingAndTruncatedFilesAreErrors) {
  const auto good = png("a.png", pattern(64, 64, 1));
  EXPECT_THAT(error({.reference = good, .image = file("none.png")}), HasSubstr("none.png"));
  const std::string bytes = read_file(good);
  write_file_atomic(file("half.png"), bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(error({.reference = file("half.png"), .image = good}), HasSubstr("half.png"));
}

TEST_F(Compare, UnknownMetricSaysTheNearest) {
  const auto good = png("a.png", pattern(2, 2, 1));
  EXPECT_THAT(error({.reference = good, .image = good, .metrics = {"pearsn"}}), HasSubstr("'pearson'"));
}

TEST_F(Compare, NeverOverwritesWhatItCompares) {
  const auto a = png("a.png", pattern(2, 2, 1));
  const std::string before = read_file(a);
  EXPECT_THAT(error({.reference = a, .image = a, .difference = file("./a.png")}), HasSubstr("overwritten"));
  EXPECT_EQ(read_file(a), before);
}

TEST_F(Compare, BothPicturesNeedFilesOfTheirOwn) {
  const auto a = png("a.png", pattern(2, 2, 1));
  EXPECT_THAT(error({.reference = a, .image = a, .difference = file("z.png"), .heat = file("./z.png")}),
              HasSubstr("the difference image and the heat map would be one file"));
  EXPECT_FALSE(std::filesystem::exists(file("z.png")));
}

TEST_F(Compare, OutputsArePng) {
  const auto a = png("a.png", pattern(2, 2, 1));
  EXPECT_THAT(error({.reference = a, .image = a, .heat = file("h.jpg")}), HasSubstr(".png"));
}

}  // namespace
}  // namespace lightbench
