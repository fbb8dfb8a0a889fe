#include "base/color.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace lightbench {
namespace {

TEST(Color, EveryByteSurvivesDecodingAndEncoding) {
  for (int i = 0; i < 256; ++i) {
    Image image(1, 1, 3, srgb_decode8(std::uint8_t(i)));
    EXPECT_EQ(to_srgb8(image).data[0], i);
  }
}

TEST(Color, LinearHalfIsByte188) {
  // 1.055 * 0.5^(1/2.4) - 0.055 = 0.7354, times 255 = 187.5 -> 188.
  EXPECT_EQ(to_srgb8(Image(1, 1, 3, 0.5f)).data[0], 188);
}

TEST(Color, ValuesOutsideTheRangeAreClamped) {
  Image image(1, 1, 3);
  image.data = {-1.0f, 7.0f, std::numeric_limits<float>::infinity()};
  EXPECT_EQ(to_srgb8(image).data, (std::vector<std::uint8_t>{0, 255, 255}));
}

TEST(Color, AlphaIsNotEncoded) {
  const Image8 encoded = to_srgb8(Image(1, 1, 4, 0.5f));
  EXPECT_EQ(encoded.data[2], 188);
  EXPECT_EQ(encoded.data[3], 128);
  EXPECT_FLOAT_EQ(from_srgb8(encoded).data[3], 128.0f / 255.0f);
}

TEST(Color, FindsTheFirstComponentThatIsNotFinite) {
  Image image(2, 1, 3, 1.0f);
  EXPECT_EQ(first_non_finite(image), -1);
  image.data[4] = std::nanf("");
  EXPECT_EQ(first_non_finite(image), 4);
}

TEST(Color, BoxDownsampleIsTheMeanOfEachBlock) {
  Image image(4, 2, 1);
  image.data = {0, 1, 10, 10, 2, 5, 10, 10};
  const Image result = box_downsample(image, 2);
  EXPECT_EQ(result.width, 2);
  EXPECT_EQ(result.height, 1);
  EXPECT_FLOAT_EQ(result.data[0], 2.0f);
  EXPECT_FLOAT_EQ(result.data[1], 10.0f);
}

TEST(MeanLuminance, WeighsComponentsAndCoverage) {
  Image image(2, 1, 4);
  image.data = {1, 1, 1, 1, 0, 5, 0, 0};
  EXPECT_NEAR(mean_luminance(image), 1, 1e-12);
  image.data = {0, 1, 0, 0.5f, 0, 0, 0, 0.5f};
  EXPECT_NEAR(mean_luminance(image), 0.7152 / 2, 1e-7);
  EXPECT_EQ(mean_luminance(Image(1, 1, 4)), 0);
}

}  // namespace
}  // namespace lightbench
