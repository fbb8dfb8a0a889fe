#include "base/orientation.h"

#include <gtest/gtest.h>

#include "base/color.h"
#include "base/files.h"
#include "base/image_io.h"
#include "image_samples.h"
#include "raw_images.h"

namespace lightbench {
namespace {

using namespace std::string_literals;

/// Greys that JPEG keeps apart, in an image of 3 x 2.
constexpr int kGreys[] = {10, 50, 90, 130, 170, 210};

Image8 stored() {
  Image8 image(3, 2, 3);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = std::uint8_t(kGreys[i / 3]);
  return image;
}

/// What is seen, as numbers of the stored pixels in rows from above, for each orientation.
struct Seen {
  int width;
  std::vector<int> pixels;
};

const Seen kSeen[] = {{3, {0, 1, 2, 3, 4, 5}}, {3, {2, 1, 0, 5, 4, 3}}, {3, {5, 4, 3, 2, 1, 0}},
                      {3, {3, 4, 5, 0, 1, 2}}, {2, {0, 3, 1, 4, 2, 5}}, {2, {3, 0, 4, 1, 5, 2}},
                      {2, {5, 2, 4, 1, 3, 0}}, {2, {2, 5, 1, 4, 0, 3}}};

const Seen& seen(Orientation orientation) {
  return kSeen[orientation - 1];
}

void expect_seen(const Image8& image, Orientation orientation, int tolerance, const std::string& what) {
  const Seen& right = seen(orientation);
  ASSERT_EQ(image.width, right.width) << what << orientation;
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(image.data[i * std::size_t(image.channels)], kGreys[right.pixels[i]], tolerance)
        << what << orientation << " pixel " << i;
}

class Oriented : public ::testing::TestWithParam<Orientation> {
 protected:
  void expect(const std::string& bytes, int tolerance, const std::string& what) {
    const auto file = folder_.path() / "picture";
    write_file_atomic(file, bytes);
    expect_seen(read_image_srgb8(file), GetParam(), tolerance, what);
    expect_seen(read_image_rgba8(file), GetParam(), tolerance, what + " as a texture");
    expect_seen(to_srgb8(read_image(file)), GetParam(), tolerance, what + " as light");
  }

  TemporaryFolder folder_;
};

TEST_P(Oriented, ImagesAreTurned) {
  expect_seen(upright(stored(), GetParam()), GetParam(), 0, "image");
}

TEST_P(Oriented, PngHasItInExif) {
  const Image8 image = stored();
  const std::string pixels(image.data.begin(), image.data.end());
  const std::string rows = '\0' + pixels.substr(0, 9) + '\0' + pixels.substr(9);
  expect(test::raw_png(3, 2, test::PngColor::rgb, 8, rows,
                       test::png_chunk("eXIf", test::exif_block(GetParam()))),
         0, "PNG");
}

TEST_P(Oriented, TiffHasItAsATag) {
  expect(test::encoded("tiff", stored(), "", GetParam()), 0, "TIFF");
}

TEST_P(Oriented, JpegHasItInExif) {
  // Greys have no chroma to lose; a block of the 3 x 2 pixels is rounded by some units.
  expect(test::encoded("jpeg", stored(), "jpeg:100", GetParam()), 8, "JPEG");
}

TEST_P(Oriented, WebpHasItInExif) {
  std::string bytes = test::encoded("webp", stored(), "lossless");
  const std::string exif = test::exif_block(GetParam());
  bytes += "EXIF" + test::little_endian(std::uint32_t(exif.size())) + exif;
  bytes.replace(4, 4, test::little_endian(std::uint32_t(bytes.size() - 8)));
  expect(bytes, 0, "WebP");
}

TEST_P(Oriented, HdrHasItInItsLineOfSizes) {
  constexpr const char* kLines[] = {"-Y 2 +X 3", "-Y 2 -X 3", "+Y 2 -X 3", "+Y 2 +X 3",
                                    "+X 2 -Y 3", "-X 2 -Y 3", "-X 2 +Y 3", "+X 2 +Y 3"};
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"s + kLines[GetParam() - 1] + "\n";
  for (const int grey : kGreys) bytes += std::string(3, char(grey)) + '\x80';  // grey / 256
  const auto file = folder_.path() / "a.hdr";
  write_file_atomic(file, bytes);
  const Image image = read_image(file);
  ASSERT_EQ(image.width, seen(GetParam()).width);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(image.data[3 * i], kGreys[seen(GetParam()).pixels[i]] / 256.0, 0.5 / 256) << i;
}

INSTANTIATE_TEST_SUITE_P(All, Oriented, ::testing::Range(1, 9));

TEST(Orientation, OfABlockThatMakesNoSenseIsAsStored) {
  const std::string exif = test::exif_block(6);
  EXPECT_EQ(exif_orientation(exif), 6);
  EXPECT_EQ(exif_orientation("Exif\0\0"s + exif), 6);
  for (std::size_t length = 0; length < 18; ++length) EXPECT_EQ(exif_orientation(exif.substr(0, length)), 1);
  EXPECT_EQ(exif_orientation(test::exif_block(0)), 1);
  EXPECT_EQ(exif_orientation(test::exif_block(9)), 1);
  EXPECT_EQ(exif_orientation("XX" + exif.substr(2)), 1);
}

TEST(Orientation, IsNotTakenFromFormatsThatPassOnWhatAnotherFileSaid) {
  const TemporaryFolder folder;
  write_file_atomic(folder.path() / "a.exr", test::encoded("openexr", stored(), "", 6));
  EXPECT_EQ(read_image(folder.path() / "a.exr").width, 3);
}

}  // namespace
}  // namespace lightbench
