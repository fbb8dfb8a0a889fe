#include "base/image_io.h"

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/color.h"
#include "base/error.h"
#include "base/files.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::size_t files_in(const std::filesystem::path& folder) {
  return std::size_t(std::distance(std::filesystem::directory_iterator(folder), {}));
}

Image gradient(int width, int height, int channels) {
  Image image(width, height, channels);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = float(i) / float(image.data.size());
  return image;
}

class ImageIo : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
};

TEST_F(ImageIo, FloatExrKeepsEveryBit) {
  const Image image = gradient(7, 5, 4);
  write_exr(file("a.exr"), image, PixelType::float32);
  EXPECT_EQ(read_image(file("a.exr")), image);
}

TEST_F(ImageIo, AlphaDoesNotTouchColour) {
  Image image(1, 1, 4);
  image.data = {0.8f, 0.4f, 0.2f, 0.0f};
  write_exr(file("a.exr"), image, PixelType::float32);
  EXPECT_EQ(read_image(file("a.exr")), image);
  const Image8 bytes = to_srgb8(image);
  write_png(file("a.png"), bytes);
  EXPECT_EQ(read_image_srgb8(file("a.png")), bytes);
}

TEST_F(ImageIo, SingleChannelBuffersStaySingle) {
  const Image image = gradient(3, 3, 1);
  write_exr(file("depth.exr"), image, PixelType::float32);
  EXPECT_EQ(read_float_image(file("depth.exr")), image);
}

TEST_F(ImageIo, MetadataIsKept) {
  write_exr(file("a.exr"), gradient(2, 2, 3), PixelType::half, {{"lightbench:view", "a \"quoted\" name"}});
  EXPECT_EQ(read_image_metadata(file("a.exr"))["lightbench:view"], "a \"quoted\" name");
}

TEST_F(ImageIo, PngOfTheRoundedExrIsWhatTheExrScoresAs) {
  const Image image = gradient(16, 16, 3);
  write_exr(file("a.exr"), image, PixelType::half);
  write_png(file("a.png"), to_srgb8(read_image(file("a.exr"))));
  EXPECT_EQ(read_image_srgb8(file("a.png")), read_image_srgb8(file("a.exr")));
}

TEST_F(ImageIo, EqualImagesGiveEqualPngBytes) {
  const Image8 image = to_srgb8(gradient(9, 4, 3));
  write_png(file("a.png"), image);
  write_png(file("b.png"), image);
  EXPECT_EQ(read_file(file("a.png")), read_file(file("b.png")));
  EXPECT_EQ(encode_png(image), read_file(file("a.png")));
}

TEST_F(ImageIo, GreyBecomesRgb) {
  write_png(file("grey.png"), Image8(2, 1, 1, 128));
  EXPECT_EQ(read_image_srgb8(file("grey.png")), Image8(2, 1, 3, 128));
}

TEST_F(ImageIo, TruncatedFilesAreErrorsWithTheirPath) {
  for (const char* name : {"a.exr", "a.png"}) {
    if (std::string(name) == "a.exr")
      write_exr(file(name), gradient(64, 64, 3), PixelType::half);
    else
      write_png(file(name), to_srgb8(gradient(64, 64, 3)));
    std::filesystem::resize_file(file(name), std::filesystem::file_size(file(name)) / 2);
    EXPECT_THAT(error_of([&] { read_image(file(name)); }), HasSubstr(file(name).string()));
  }
}

TEST_F(ImageIo, MissingAndForeignFilesAreErrors) {
  EXPECT_THAT(error_of([&] { read_image(file("none.png")); }), HasSubstr("no such file"));
  write_file_atomic(file("text.png"), "this is no image");
  EXPECT_THAT(error_of([&] { read_image(file("text.png")); }), HasSubstr("not a readable image"));
  EXPECT_THAT(error_of([&] { read_image(folder_.path()); }), HasSubstr("is a folder"));
}

TEST_F(ImageIo, NanInAScoredImageIsAnErrorThatNamesThePixel) {
  Image image(4, 4, 3, 0.5f);
  image.pixel(2, 1)[1] = std::nanf("");
  write_exr(file("nan.exr"), image, PixelType::float32);
  EXPECT_THAT(error_of([&] { read_image_srgb8(file("nan.exr")); }), HasSubstr("pixel (2, 1)"));
}

TEST_F(ImageIo, ImpossibleSizesAreRefused) {
  EXPECT_THAT(error_of([] { check_image_size(0, 10, "x"); }), HasSubstr("0 x 10"));
  EXPECT_THAT(error_of([] { check_image_size(100000, 100000, "x"); }), HasSubstr("too large"));
  EXPECT_NO_THROW(check_image_size(16384, 16384, "x"));
}

TEST_F(ImageIo, AFailedWriteLeavesNothing) {
  EXPECT_THAT(error_of([&] { write_png(file("a.unknown"), Image8(2, 2, 3)); }), HasSubstr("a.unknown"));
  EXPECT_EQ(files_in(folder_.path()), 0u);
}

}  // namespace
}  // namespace lightbench
