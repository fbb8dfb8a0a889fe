#include "pipeline/snapshot.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"

namespace lightbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ImagePair : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::filesystem::path exr_ = folder_.path() / "a.exr";
  std::filesystem::path png_ = folder_.path() / "a.png";
};

TEST_F(ImagePair, ThePngIsTheRoundedSrgbOfTheExr) {
  Image image(1, 1, 4);
  image.data = {0.0f, 0.5f, 2.0f, 1.0f};
  write_image_pair(exr_, png_, image, {});
  EXPECT_THAT(read_image_srgb8(png_).data, ElementsAre(0, 188, 255));  // sRGB of 0.5 is 187.5
  EXPECT_EQ(read_image(exr_).channels, 4);
}

TEST_F(ImagePair, ANumberThatIsNoneLeavesNoFile) {
  Image image(3, 2, 4, 0.5f);
  image.pixel(2, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  try {
    write_image_pair(exr_, png_, image, {});
    FAIL() << "NaN was written";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("(2, 1)"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(ImagePair, WhatIsTooBrightIsClampedWithAWarning) {
  Image image(2, 1, 3, 0.5f);
  image.data[1] = 1e6f;
  const auto warnings = write_image_pair(exr_, png_, image, {});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings.front(), HasSubstr("1 of 2 pixels have a number beyond 65504"));
  EXPECT_EQ(read_image(exr_).data[1], kLargestHalf);
  EXPECT_THAT(read_image_srgb8(png_).data, ElementsAre(188, 255, 188, 188, 188, 188));
  EXPECT_THAT(write_picture(exr_, image), ::testing::SizeIs(1));
  EXPECT_THAT(write_picture(png_, image), ::testing::IsEmpty());  // 8 bits end at 1 anyway
  image.data[1] = 65504;
  EXPECT_THAT(write_image_pair(exr_, png_, image, {}), ::testing::IsEmpty());
}

TEST_F(ImagePair, ABufferOfOneComponentIsStretchedForTheEyeAndKeptAsItIs) {
  Image depth(3, 1, 1);
  depth.data = {2, 3, 4};
  write_buffer_pair(exr_, png_, depth);
  EXPECT_THAT(read_float_image(exr_).data, ElementsAre(2, 3, 4));
  EXPECT_EQ(read_image_srgb8(png_).data[3], 128);  // grey reads as three components
}

TEST_F(ImagePair, NegativeComponentsAreShiftedForTheEye) {
  Image normal(1, 1, 3);
  normal.data = {-1, 0, 1};
  write_buffer_pair(exr_, png_, normal);
  EXPECT_THAT(read_image_srgb8(png_).data, ElementsAre(0, 128, 255));
}

TEST(BackEnd, AnUnknownNameIsAnError) {
  EXPECT_EQ(parse_gl("egl", ""), GlBackend::egl);
  EXPECT_THROW(parse_gl("glx", "--gl"), Error);
}

}  // namespace
}  // namespace lightbench
