#include "reports/difference_image.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "base/error.h"
#include "reports/metrics/luv.h"
#include "reports/small_font.h"
#include "tests/reports/metric_pair.h"

namespace lightbench {
namespace {

using test::pattern;
using test::row_of;

TEST(DifferenceImage, IsTheNegativeOfTheAbsoluteError) {
  const Image8 difference = difference_image(row_of({{10, 200, 0}}), row_of({{15, 100, 255}}));
  EXPECT_EQ(difference, row_of({{250, 155, 0}}));
}

TEST(DifferenceImage, IsWhiteWhereEqual) {
  const Image8 image = pattern(9, 7, 1);
  EXPECT_EQ(difference_image(image, image), Image8(9, 7, 3, 255));
}

TEST(DifferenceImage, RefusesDifferentSizes) {
  EXPECT_THROW(difference_image(Image8(2, 2, 3), Image8(2, 3, 3)), Error);
  EXPECT_THROW(heat_map(Image8(2, 2, 3), Image8(2, 3, 3)), Error);
}

TEST(HeatColor, LightnessRisesOverTheWholeMap) {
  double last = -1;
  for (int i = 0; i <= 48; ++i) {
    const auto color = heat_color(i / 48.0);
    const double lightness = to_luv(color[0], color[1], color[2]).l;
    EXPECT_GT(lightness, last) << i;
    last = lightness;
  }
}

TEST(HeatColor, IsClamped) {
  EXPECT_EQ(heat_color(-1), heat_color(0));
  EXPECT_EQ(heat_color(7), heat_color(1));
}

TEST(HeatMap, HasAFixedScaleOverTheMeanOfTheComponents) {
  // Mean errors 0, 32 and 100 of 255 with an end of 64.
  const Image8 a = row_of({{9, 9, 9}, {100, 100, 100}, {0, 0, 0}});
  const Image8 b = row_of({{9, 9, 9}, {196, 100, 100}, {100, 100, 100}});
  const Image8 heat = heat_map(a, b, 64);
  const double expected[] = {0.0, 0.5, 1.0};
  for (int x = 0; x < 3; ++x) EXPECT_TRUE(std::ranges::equal(heat.pixel(x, 0), heat_color(expected[x]))) << x;
}

TEST(HeatMap, AddsABarThatHoldsTheWholeMap) {
  const Image8 image(640, 4, 3, 50);
  const Image8 heat = heat_map(image, image);
  ASSERT_EQ(heat.height, 4 + heat_bar_height(640));
  const int y = 4 + heat_bar_height(640) / 3;
  EXPECT_TRUE(std::ranges::equal(heat.pixel(6, y), heat_color(0)));
  EXPECT_TRUE(std::ranges::equal(heat.pixel(640 - 7, y), heat_color(1)));
}

TEST(HeatMap, BarHasLabels) {
  const Image8 image(640, 4, 3, 50);
  const Image8 heat = heat_map(image, image);
  std::ptrdiff_t bright = 0;
  for (int y = 4 + heat_bar_height(640) / 2; y < heat.height; ++y)
    for (int x = 0; x < heat.width; ++x) bright += heat.pixel(x, y)[0] > 200;
  EXPECT_GT(bright, 100);
}

TEST(HeatMap, WorksOnTheSmallestImage) {
  const Image8 heat = heat_map(Image8(1, 1, 3, 0), Image8(1, 1, 3, 255));
  EXPECT_TRUE(std::ranges::equal(heat.pixel(0, 0), heat_color(1)));
}

TEST(SmallFont, IsClippedToTheImage) {
  Image8 image(6, 6, 3);
  draw_text(image, -3, -2, "88", 2, {255, 255, 255});
  draw_text(image, 5, 5, "8", 3, {255, 255, 255});
  EXPECT_EQ(image.data.size(), 6u * 6u * 3u);
  EXPECT_TRUE(std::ranges::any_of(image.data, [](std::uint8_t value) { return value == 255; }));
}

TEST(SmallFont, WidthIsThatOfItsGlyphs) {
  EXPECT_EQ(text_width("", 2), 0);
  EXPECT_EQ(text_width("64", 2), 22);
}

}  // namespace
}  // namespace lightbench
