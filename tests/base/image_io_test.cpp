#include "base/image_io.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include <OpenImageIO/deepdata.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/color.h"
#include "base/error.h"
#include "base/files.h"
#include "image_samples.h"
#include "small_disk.h"

namespace lightbench {
namespace {

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::Eq;
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

/// Without waiting for the disk.
void write_quickly(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::remove(file);  // some file systems wait when a file is emptied and written anew
  std::ofstream(file, std::ios::binary) << bytes;
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
  EXPECT_THAT(error_of([&] { read_image(file("text.png")); }), HasSubstr("in no image format"));
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
  EXPECT_THAT(error_of([&] { write_png(file("a.png"), Image8(2, 2, 6)); }), HasSubstr("a.png"));
  EXPECT_THAT(error_of([&] { write_png(file("a.png"), Image8()); }), HasSubstr("a.png"));
  EXPECT_EQ(files_in(folder_.path()), 0u);
}

TEST_F(ImageIo, NumbersBeyondHalfFloatsAreClampedAndCounted) {
  Image image(3, 1, 3, 0.5f);
  image.data = {65504, 65519, -65519, 65520, 1e9f, 1, -1e9f, 0, 0.25f};
  EXPECT_EQ(write_exr(file("a.exr"), image, PixelType::half), 2u);  // 65519 is rounded to 65504
  EXPECT_THAT(read_float_image(file("a.exr")).data,
              ElementsAre(65504, 65504, -65504, 65504, 65504, 1, -65504, 0, 0.25f));
  EXPECT_EQ(write_exr(file("b.exr"), image, PixelType::float32), 0u);
  EXPECT_EQ(read_float_image(file("b.exr")), image);
}

TEST_F(ImageIo, RgbaIsWhatTheOtherReadersGiveWithAnAlpha) {
  for (const int channels : {1, 2, 3, 4}) {
    write_png(file("a.png"), test::picture(5, 4, channels));
    const Image8 plain = read_image_srgb8(file("a.png"));
    const Image8 rgba = read_image_rgba8(file("a.png"));
    ASSERT_EQ(rgba.channels, 4);
    if (plain.channels == 3) {
      EXPECT_EQ(first_channels(rgba, 3), plain) << channels;
      EXPECT_EQ(rgba.pixel(2, 1)[3], 255);
    } else {
      EXPECT_EQ(rgba.pixel(2, 1)[3], plain.pixel(2, 1)[3]);
      EXPECT_EQ(rgba.pixel(2, 1)[0], test::picture(5, 4, channels).pixel(2, 1)[0]);
    }
  }
  write_exr(file("a.exr"), gradient(4, 3, 3), PixelType::half);
  EXPECT_EQ(first_channels(read_image_rgba8(file("a.exr")), 3), read_image_srgb8(file("a.exr")));
}

TEST_F(ImageIo, TexturesThatAreTooLargeAreRefusedByTheirHeader) {
  write_png(file("a.png"), Image8(30, 2, 3));
  EXPECT_THAT(error_of([&] { read_image_rgba8(file("a.png"), 29); }),
              HasSubstr("30 x 2 pixels are more than 29"));
  EXPECT_EQ(read_image_rgba8(file("a.png"), 30).width, 30);
}

TEST_F(ImageIo, AllFormatsOfTheListAreRead) {
  for (const std::string& format : test::kReadFormats) {
    const auto name = file(test::file_name(format));
    write_file_atomic(name, test::encoded(format, test::picture()));
    const Image8 image = read_image_srgb8(name);
    EXPECT_EQ(image.width, 23) << format;
    EXPECT_EQ(image.height, 17) << format;
  }
  for (const std::string& format : test::kLosslessFormats) {
    write_file_atomic(file(test::file_name(format)), test::encoded(format, test::picture()));
    EXPECT_EQ(read_image_srgb8(file(test::file_name(format))), test::picture()) << format;
  }
}

TEST_F(ImageIo, APictureThatEndsAnywhereBeforeItsLastBytesIsAnError) {
  for (const std::string& format : test::kReadFormats) {
    const std::string bytes = test::encoded(format, test::picture());
    // What follows the pixels of a TGA.
    const std::size_t spare = format == "targa" ? bytes.size() - 18 - std::size_t{23} * 17 * 3 : 0;
    for (std::size_t length = 0; length + spare < bytes.size(); length += 7) {
      write_quickly(file(test::file_name(format)), bytes.substr(0, length));
      ASSERT_THAT(error_of([&] { read_image(file(test::file_name(format))); }), HasSubstr("picture."))
          << format << " cut at " << length;
    }
  }
}

TEST_F(ImageIo, DamagedPicturesAreReadOrErrors) {
  std::mt19937 random(1);
  for (const std::string& format : test::kReadFormats) {
    const std::string bytes = test::encoded(format, test::picture());
    for (int i = 0; i < 60; ++i) {
      std::string damaged = bytes;
      for (int k = 0; k < 3; ++k) damaged[random() % (i % 2 == 0 ? 64 : damaged.size())] = char(random());
      write_quickly(file(test::file_name(format)), damaged);
      const std::string error = error_of([&] { read_image_rgba8(file(test::file_name(format))); });
      ASSERT_THAT(error, AnyOf(HasSubstr("picture."), Eq("no error")));
    }
  }
}

TEST_F(ImageIo, AForeignFileIsNotEvenTried) {
  write_file_atomic(file("x.png"), std::string("GIF89a\xff\xff\xff\xff\xf7\0\0,", 14));
  EXPECT_THAT(error_of([&] { read_image_rgba8(file("x.png")); }), HasSubstr("in the format GIF"));
}

TEST_F(ImageIo, ADeepImageIsAnErrorThatSaysSo) {
  OIIO::ImageSpec spec(2, 2, 2, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"R", "Z"};
  spec.deep = true;
  OIIO::DeepData data(spec);
  auto output = OIIO::ImageOutput::create("openexr");
  ASSERT_TRUE(output->open(file("deep.exr").string(), spec) && output->write_deep_image(data) &&
              output->close());
  EXPECT_THAT(error_of([&] { read_image(file("deep.exr")); }), HasSubstr("deep image"));
}

TEST_F(ImageIo, ASizeThatTheBytesCannotHoldIsMadeUp) {
  write_file_atomic(file("bomb.pbm"), "P4\n30000 8000\n" + std::string(100, '\xff'));
  EXPECT_THAT(error_of([&] { read_image_rgba8(file("bomb.pbm")); }),
              HasSubstr("cannot hold 30000 x 8000 pixels"));
  std::string bytes = test::encoded("targa", test::picture());
  bytes[13] = bytes[15] = 60;
  write_file_atomic(file("bomb.tga"), bytes);
  EXPECT_THAT(error_of([&] { read_image_rgba8(file("bomb.tga")); }), HasSubstr("cannot hold"));
}

TEST(FullDisk, APngIsWholeOrTheOldOne) {
  const Image8 image = test::picture(90, 80);
  if (!test::with_small_disk([&](const test::SmallDisk& disk) {
        test::expect_whole_or_old(disk, "a.png", [&](const auto& file) { write_png(file, image); });
      }))
    GTEST_SKIP() << test::kNoMounts;
}

TEST_F(ImageIo, AnExrDoesNotTellWhenItWasWritten) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.exr";
  write_exr(file, Image(2, 2, 3, 0.5f), PixelType::half);
  EXPECT_EQ(read_image_metadata(file).at("DateTime"), "1970:01:01 00:00:00");
}

TEST(FullDisk, AnExrIsWholeOrTheOldOne) {
  const Image image = from_srgb8(test::picture(90, 80, 4));
  if (!test::with_small_disk([&](const test::SmallDisk& disk) {
        test::expect_whole_or_old(disk, "a.exr", [&](const auto& file) {
          write_exr(file, image, PixelType::half, {{"k", "v"}});
        });
      }))
    GTEST_SKIP() << test::kNoMounts;
}

}  // namespace
}  // namespace lightbench
