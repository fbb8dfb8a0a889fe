#include "reports/metrics/local_error.h"

#include <gtest/gtest.h>

#include "reports/metrics/block_error.h"
#include "tests/reports/metric_pair.h"

namespace lightbench {
namespace {

using test::compute;
using test::pattern;
using test::row_of;

Image8 grey(int width, int height, std::uint8_t level = 100) {
  return Image8(width, height, 3, level);
}

void fill(Image8& image, const PixelBox& box, std::uint8_t level) {
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x)
      for (std::uint8_t& component : image.pixel(x, y)) component = level;
}

double value(const char* metric, const Image8& a, const Image8& b) {
  return compute(metric, a, b).value.value_or(-1);
}

constexpr const char* kLocalMetrics[] = {"max_error", "p99_error", "bad_pixels", "block_error"};

TEST(LocalErrors, AreZeroForIdenticalPictures) {
  const Image8 a = pattern(37, 19, 1);
  for (const char* metric : kLocalMetrics) EXPECT_EQ(value(metric, a, a), 0) << metric;
}

TEST(LocalErrors, AreNoPartOfAJobThatDoesNotNameThem) {
  for (const char* metric : kLocalMetrics)
    for (const std::string& name : default_metrics()) EXPECT_NE(name, metric);
}

TEST(LocalErrors, OfAPatchThatTheMeanHardlySees) {
  const Image8 a = grey(320, 240);
  Image8 b = a;
  fill(b, {200, 50, 12, 12}, 228);
  EXPECT_LT(value("mean_error", a, b), 0.25);
  EXPECT_EQ(value("max_error", a, b), 128);
  EXPECT_DOUBLE_EQ(value("bad_pixels", a, b), 100.0 * 144 / (320 * 240));
  EXPECT_DOUBLE_EQ(value("block_error", a, b), 128.0 * 144 / 256);
  EXPECT_EQ(value("p99_error", a, b), 0) << "the patch is less than 1 % of the picture";
}

TEST(MaxError, SeesOneComponentOfOnePixelInBothDirections) {
  const Image8 a = grey(1024, 768);
  Image8 b = a;
  b.pixel(1023, 767)[2] = 30;
  EXPECT_EQ(value("max_error", a, b), 70);
  EXPECT_EQ(value("max_error", b, a), 70);
}

TEST(P99Error, IsTheNearestRank) {
  Image8 a = grey(100, 2), b = a;
  b.pixel(0, 0)[0] = 140;
  b.pixel(1, 0)[0] = 120;
  EXPECT_EQ(value("p99_error", a, b), 0) << "two of 200 pixels are the last 1 %";
  b.pixel(2, 0)[0] = 110;
  EXPECT_EQ(value("p99_error", a, b), 10);
}

TEST(BadPixels, CountsWhatIsMoreThanEightOff) {
  const Image8 a = row_of({{50, 50, 50}, {50, 50, 50}, {50, 50, 50}, {50, 50, 50}});
  const Image8 b = row_of({{50, 50, 50}, {58, 42, 58}, {50, 59, 50}, {50, 50, 41}});
  EXPECT_EQ(value("bad_pixels", a, b), 50);
}

TEST(BlockError, FindsAFaintPatchAmongStrongerSinglePixels) {
  const Image8 a = grey(128, 96);
  Image8 b = a;
  for (int x = 0; x < 128; x += 16) b.pixel(x, 90)[0] = 255;
  fill(b, {37, 21, 16, 16}, 110);
  const WorstBlock worst = worst_block(a, b);
  EXPECT_EQ(worst.box, (PixelBox{37, 21, 16, 16}));
  EXPECT_DOUBLE_EQ(worst.mean_error, 10);
}

TEST(BlockError, ReachesTheEdgesOfThePicture) {
  const Image8 a = grey(50, 40);
  for (const PixelBox& corner : {PixelBox{0, 0, 16, 16}, PixelBox{34, 24, 16, 16}}) {
    Image8 b = a;
    fill(b, corner, 101);
    EXPECT_EQ(worst_block(a, b).box, corner);
  }
}

TEST(BlockError, OfAPictureThatIsSmallerIsItsMean) {
  const Image8 a = pattern(7, 3, 1), b = pattern(7, 3, 2);
  EXPECT_EQ(worst_block(a, b).box, (PixelBox{0, 0, 7, 3}));
  EXPECT_DOUBLE_EQ(value("block_error", a, b), value("mean_error", a, b));
}

TEST(BlockError, IsTheLargestOfAllBlocksOneByOne) {
  const Image8 a = pattern(41, 33, 1), b = pattern(41, 33, 2);
  double largest = 0;
  for (int y = 0; y + 16 <= 33; ++y)
    for (int x = 0; x + 16 <= 41; ++x) {
      int sum = 0;
      for (int dy = 0; dy < 16; ++dy)
        for (int dx = 0; dx < 16; ++dx)
          for (std::size_t c = 0; c < 3; ++c)
            sum += std::abs(a.pixel(x + dx, y + dy)[c] - b.pixel(x + dx, y + dy)[c]);
      largest = std::max(largest, sum / (3.0 * 256));
    }
  EXPECT_DOUBLE_EQ(value("block_error", a, b), largest);
}

}  // namespace
}  // namespace lightbench
