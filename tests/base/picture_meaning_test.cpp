#include <cmath>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/color.h"
#include "base/error.h"
#include "base/files.h"
#include "base/image_io.h"
#include "image_samples.h"
#include "raw_images.h"

namespace lightbench {
namespace {

using namespace std::string_literals;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::Le;
using ::testing::ThrowsMessage;

using test::PngColor;

/// What the numbers of a file stand for.
class PictureMeaning : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    write_file_atomic(folder_.path() / name, bytes);
    return folder_.path() / name;
  }

  std::filesystem::path tiff(const std::string& name, const OIIO::ImageSpec& spec,
                             const std::vector<float>& pixels) const {
    const std::string file = (folder_.path() / name).string();
    auto output = OIIO::ImageOutput::create("tiff");
    if (!output->open(file, spec) || !output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) ||
        !output->close())
      throw Error(output->geterror(), file);
    return file;
  }

  static std::vector<int> first_pixel(const Image8& image) {
    return {image.data.begin(), image.data.begin() + image.channels};
  }

  static std::string gamma(std::uint32_t hundred_thousandths) {
    return test::png_chunk("gAMA", test::big_endian(hundred_thousandths));
  }

  static std::string primaries(std::initializer_list<std::uint32_t> numbers) {
    std::string data;
    for (const std::uint32_t number : numbers) data += test::big_endian(number);
    return test::png_chunk("cHRM", data);
  }

  /// A pixel of 8-bit RGB.
  std::filesystem::path pixel(const std::string& chunks, const std::string& rgb = "\x80\x10\xff") const {
    return write("a.png", test::raw_png(1, 1, PngColor::rgb, 8, '\0' + rgb, chunks));
  }

  TemporaryFolder folder_;
};

TEST_F(PictureMeaning, GammaOfAPngIsHonoured) {
  const Image linear = read_image(pixel(gamma(100000)));
  EXPECT_FLOAT_EQ(linear.data[0], 128 / 255.0f);
  EXPECT_FLOAT_EQ(linear.data[1], 16 / 255.0f);
  EXPECT_THAT(first_pixel(read_image_srgb8(pixel(gamma(100000)))), ElementsAre(188, 71, 255));
  EXPECT_THAT(first_pixel(read_image_rgba8(pixel(gamma(100000)))), ElementsAre(188, 71, 255, 255));
  EXPECT_NEAR(read_image(pixel(gamma(45455))).data[1], std::pow(16 / 255.0, 2.2), 1e-6);  // 1 / 0.45455
}

TEST_F(PictureMeaning, GammaOfAPngOf16BitsWithAlphaIsHonoured) {
  const auto file =
      write("a.png", test::raw_png(1, 1, PngColor::grey_alpha, 16, "\0\x80\0\x40\0"s, gamma(100000)));
  const float color = 0x8000 / 65535.0f, alpha = 0x4000 / 65535.0f;
  EXPECT_THAT(read_image(file).data, ElementsAre(color * alpha, color * alpha, color * alpha, alpha));
  EXPECT_THAT(first_pixel(read_image_rgba8(file)), ElementsAre(188, 188, 188, 64));
}

TEST_F(PictureMeaning, SrgbAndProfilesStandAboveGamma) {
  const std::string srgb = test::png_chunk("sRGB", "\1"s);
  const std::string profile = test::png_chunk("iCCP", "p\0\0"s + "\x78\x9c\x03\0\0\0\0\1"s);
  for (const std::string& chunks : {srgb + gamma(100000), gamma(100000) + srgb, profile + gamma(100000)})
    EXPECT_THAT(first_pixel(read_image_srgb8(pixel(chunks))), ElementsAre(128, 16, 255));
}

TEST_F(PictureMeaning, TheStandInOfSrgbIsSrgb) {
  const std::string srgb = primaries({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000});
  const std::string other = primaries({31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000});
  EXPECT_THAT(first_pixel(read_image_srgb8(pixel(gamma(45455) + srgb))), ElementsAre(128, 16, 255));
  EXPECT_THAT(first_pixel(read_image_srgb8(pixel(gamma(100000) + srgb))), ElementsAre(188, 71, 255));
  EXPECT_NE(read_image_srgb8(pixel(gamma(45455) + other)).data[1], 16);
}

TEST_F(PictureMeaning, AGammaOfNothingIsNone) {
  EXPECT_THAT(first_pixel(read_image_srgb8(pixel(gamma(0)))), ElementsAre(128, 16, 255));
}

TEST_F(PictureMeaning, APngThatIsCutSaysNothingToTheTerminal) {
  const std::string bytes = read_file(pixel(""));
  testing::internal::CaptureStderr();
  for (std::size_t length = 16; length < bytes.size(); ++length) {
    const auto file = write("a.png", bytes.substr(0, length));
    EXPECT_THAT([&] { read_image(file); }, ThrowsMessage<Error>(HasSubstr("truncated PNG image"))) << length;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(PictureMeaning, CutPnmFilesSayWhatIsWrong) {
  EXPECT_THAT([&] { read_image(write("a.ppm", "P6\n2 2\n255\nabc")); },
              ThrowsMessage<Error>(HasSubstr("end too early")));
  EXPECT_THAT([&] { read_image(write("a.ppm", "P6\n2")); },
              ThrowsMessage<Error>(HasSubstr("header is damaged or cut")));
}

/// A PNG keeps colour and alpha apart; the EXR has the same colour times its alpha.
TEST_F(PictureMeaning, APictureIsTheSamePremultipliedOrNot) {
  Image light(16, 16, 4);
  Image8 straight(16, 16, 4);
  for (std::size_t i = 0; i < light.pixel_count(); ++i) {
    const auto alpha = std::uint8_t(i);
    for (std::size_t c = 0; c < 3; ++c) {
      straight.data[4 * i + c] = std::uint8_t(37 * i + 85 * c);
      light.data[4 * i + c] = srgb_decode8(straight.data[4 * i + c]) * float(alpha) / 255;
    }
    straight.data[4 * i + 3] = alpha;
    light.data[4 * i + 3] = float(alpha) / 255;
  }
  write_png(folder_.path() / "a.png", straight);
  write_exr(folder_.path() / "a.exr", light, PixelType::half);
  const Image8 png = read_image_srgb8(folder_.path() / "a.png"),
               exr = read_image_srgb8(folder_.path() / "a.exr");
  for (std::size_t i = 0; i < png.data.size(); ++i)
    ASSERT_NEAR(png.data[i], exr.data[i], 1) << i;  // half floats
  EXPECT_EQ(to_srgb8(read_image(folder_.path() / "a.png")), png);
}

TEST_F(PictureMeaning, ColourWithoutAlphaShowsOnlyWherePremultiplied) {
  Image light(1, 1, 4);
  light.data = {0.5f, 0.25f, 1, 0};
  write_exr(folder_.path() / "a.exr", light, PixelType::float32);
  EXPECT_EQ(read_image(folder_.path() / "a.exr"), light) << "it shines and covers nothing";
  write_png(folder_.path() / "a.png", to_srgb8(light));
  EXPECT_EQ(read_image_srgb8(folder_.path() / "a.png"), Image8(1, 1, 4, 0));
}

TEST_F(PictureMeaning, TexturesKeepColourAndAlphaApart) {
  Image8 straight(2, 1, 4);
  straight.data = {200, 100, 50, 0, 200, 100, 50, 128};
  write_png(folder_.path() / "a.png", straight);
  EXPECT_EQ(read_image_rgba8(folder_.path() / "a.png"), straight);
  Image light = from_srgb8(straight);
  for (std::size_t c = 4; c < 7; ++c) light.data[c] *= light.data[7];
  write_exr(folder_.path() / "a.exr", light, PixelType::float32);
  EXPECT_EQ(read_image_rgba8(folder_.path() / "a.exr"), straight);
}

TEST_F(PictureMeaning, TiffSaysWhetherItIsPremultiplied) {
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
  const auto associated = tiff("a.tif", spec, {100 / 255.0f, 50 / 255.0f, 0, 128 / 255.0f});
  spec.attribute("oiio:UnassociatedAlpha", 1);
  const auto unassociated = tiff("u.tif", spec, {199 / 255.0f, 100 / 255.0f, 0, 128 / 255.0f});
  EXPECT_THAT(first_pixel(read_image_rgba8(associated)), ElementsAre(199, 100, 0, 128));
  EXPECT_THAT(first_pixel(read_image_rgba8(unassociated)), ElementsAre(199, 100, 0, 128));
  const auto a = first_pixel(read_image_srgb8(associated)), u = first_pixel(read_image_srgb8(unassociated));
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(a[c], u[c], 1) << c;  // 199 is rounded
  EXPECT_NEAR(a[0], 255 * srgb_encode(srgb_decode8(199) * 128 / 255), 1);
}

TEST_F(PictureMeaning, PlanesAndFloatsOfTiffAreRead) {
  OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::FLOAT);
  spec.attribute("planarconfig", "separate");
  EXPECT_THAT(read_image(tiff("a.tif", spec, {0.5f, 0.25f, 2, 0, 1, 3})).data,
              ElementsAre(0.5f, 0.25f, 2, 0, 1, 3));
}

TEST_F(PictureMeaning, WebpIsNotPremultiplied) {
  // A pixel (200, 100, 50) with alpha 128: OpenImageIO writes other numbers than it was given.
  const std::string bytes =
      "RIFF\x1e\0\0\0WEBPVP8L\x11\0\0\0\x2f\0\0\0\x10\x07\x50\xb2\x22\x57\xa6\x80\x81\x88\xe8\x7f\0\0"s;
  const auto file = write("a.webp", bytes);
  // It has multiplied by alpha and rounded, which is up to half of 255 / 128.
  EXPECT_THAT(first_pixel(read_image_rgba8(file)), ElementsAre(AllOf(Ge(199), Le(201)), 100, 50, 128));
  const double wanted = 255 * srgb_encode(srgb_decode8(200) * 128 / 255);
  EXPECT_NEAR(read_image_srgb8(file).data[0], wanted, 1.5);
}

TEST_F(PictureMeaning, InksOfJpegAreColours) {
  const Image8 image = read_image_srgb8(LIGHTBENCH_TEST_DATA "/pictures/cmyk.jpg");  // of (200, 100, 50)
  EXPECT_THAT(first_pixel(image), ElementsAre(200, 100, 50));
}

TEST_F(PictureMeaning, AlphaOfTgaIsAlphaOnlyIfItsHeaderSaysSo) {
  EXPECT_THAT(first_pixel(read_image_srgb8(write("a.tga", test::raw_tga(1, 1, 0, "\x10\x20\x30\0"s)))),
              ElementsAre(48, 32, 16));
  EXPECT_THAT(first_pixel(read_image_rgba8(write("a.tga", test::raw_tga(1, 1, 8, "\x10\x20\x30\0"s)))),
              ElementsAre(48, 32, 16, 0));
}

TEST_F(PictureMeaning, AlphaOfBmpIsAlphaOnlyIfItHasAMask) {
  const std::string bgra = "\x10\x20\x30\x80";
  const auto picture = [&](std::initializer_list<std::uint32_t> masks) {
    return read_image_rgba8(write("a.bmp", test::raw_bmp(1, 1, masks, bgra)));
  };
  EXPECT_THAT(first_pixel(picture({})), ElementsAre(48, 32, 16, 255));
  EXPECT_THAT(first_pixel(picture({0xff0000, 0xff00, 0xff, 0})), ElementsAre(48, 32, 16, 255));
  EXPECT_THAT(first_pixel(picture({0xff0000, 0xff00, 0xff, 0xff000000})), ElementsAre(48, 32, 16, 128));
  EXPECT_THAT(
      [&] {
        picture({0xff, 0xff00, 0xff0000, 0xff000000});
      },
      ThrowsMessage<Error>(HasSubstr("in an order")));
}

TEST_F(PictureMeaning, TransparencyOfPalettesAndGreysIsAlpha) {
  const std::string palette =
      test::png_chunk("PLTE", "\x30\x20\x10\xff\xff\xff"s) + test::png_chunk("tRNS", "\x80");
  const auto colors = write("a.png", test::raw_png(2, 1, PngColor::palette, 1, "\0\x40"s, palette));
  EXPECT_THAT(read_image_rgba8(colors).data, ElementsAre(48, 32, 16, 128, 255, 255, 255, 255));
  const auto grey = write(
      "a.png", test::raw_png(2, 1, PngColor::grey, 8, "\0\x20\x30"s, test::png_chunk("tRNS", "\0\x20"s)));
  EXPECT_THAT(read_image_rgba8(grey).data, ElementsAre(32, 32, 32, 0, 48, 48, 48, 255));
}

TEST_F(PictureMeaning, SixteenBitsAreRoundedOnce) {
  const auto file = write("a.png", test::raw_png(1, 1, PngColor::rgb, 16, "\0\x80\x7f\x10\x81\xff\xff"s));
  EXPECT_THAT(first_pixel(read_image_srgb8(file)), ElementsAre(128, 16, 255));
  EXPECT_FLOAT_EQ(read_image(file).data[1], srgb_decode(0x1081 / 65535.0f));
}

TEST_F(PictureMeaning, ExposureOfHdrStaysInAndGammaGoes) {
  const std::string start = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", end = "\n-Y 1 +X 1\n\x80\x40\x20\x80";
  EXPECT_THAT(read_image(write("a.hdr", start + "EXPOSURE=4\n" + end)).data,
              ElementsAre(0.5f, 0.25f, 0.125f));
  EXPECT_THAT(read_image(write("a.hdr", start + "GAMMA=0.5\n" + end)).data,
              ElementsAre(0.25f, 0.0625f, 0.015625f));
}

}  // namespace
}  // namespace lightbench
