#include "reports/error_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/reports/metric_pair.h"

namespace lightbench {
namespace {

using testing::HasSubstr;

/// A grey picture with one box of another level.
Image8 with_box(const PixelBox& box, std::uint8_t level) {
  Image8 image(64, 48, 3, 100);
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x)
      for (std::uint8_t& component : image.pixel(x, y)) component = level;
  return image;
}

const Image8 kGrey = with_box({}, 100);

TEST(ErrorPlace, IsNoneWhereNothingDiffers) {
  EXPECT_FALSE(find_error(kGrey, kGrey));
  EXPECT_EQ(error_place_text(std::nullopt), "no pixel differs in colour\n");
}

TEST(ErrorPlace, OfAPatchIsItsBox) {
  const PixelBox patch{30, 5, 12, 9};
  const auto place = find_error(kGrey, with_box(patch, 180));
  ASSERT_TRUE(place);
  EXPECT_EQ(place->differing, 108u);
  EXPECT_EQ(place->largest, 80);
  EXPECT_EQ(place->x, 30);
  EXPECT_EQ(place->y, 5);
  EXPECT_EQ(place->region, patch);
  EXPECT_EQ(place->region_pixels, 108u);
}

TEST(ErrorPlace, OfASinglePixelIsThatPixel) {
  const auto place = find_error(kGrey, with_box({63, 47, 1, 1}, 99));
  ASSERT_TRUE(place);
  EXPECT_EQ(place->region, (PixelBox{63, 47, 1, 1}));
  EXPECT_EQ(place->region_pixels, 1u);
}

TEST(ErrorPlace, RegionEndsWhereTheErrorFallsBelowHalf) {
  Image8 broken = with_box({10, 10, 4, 4}, 161);
  for (int x = 0; x < 64; ++x) broken.pixel(x, 20)[0] = 255;   // farther off, elsewhere
  for (int x = 20; x < 64; ++x) broken.pixel(x, 20)[0] = 170;  // 70 of 155: less than half
  const auto place = find_error(kGrey, broken);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->region, (PixelBox{0, 20, 20, 1}));
}

TEST(ErrorPlace, RegionJoinsCorners) {
  Image8 broken = kGrey;
  for (int i = 0; i < 5; ++i) broken.pixel(8 + i, 30 - i)[0] = 200;
  EXPECT_EQ(find_error(kGrey, broken)->region, (PixelBox{8, 26, 5, 5}));
}

TEST(ErrorPlace, TextNamesPixelRegionAndBlock) {
  const std::string text = error_place_text(find_error(kGrey, with_box({30, 5, 16, 16}, 180)));
  EXPECT_THAT(text, HasSubstr("256 pixels differ"));
  EXPECT_THAT(text, HasSubstr("largest error 80 of 255 at x 30, y 5"));
  EXPECT_THAT(text,
              HasSubstr("worst block of 16 x 16 pixels at x 30 to 45, y 5 to 20, with a mean error of 80"));
}

}  // namespace
}  // namespace lightbench
