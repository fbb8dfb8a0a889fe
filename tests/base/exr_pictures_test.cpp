#include <fstream>

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image_io.h"
#include "raw_images.h"

namespace lightbench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using OIIO::ImageSpec;
using OIIO::TypeDesc;
using Names = std::vector<std::string>;

/// A part with channel c of pixel (x, y), counted from the corner of the data, having value(x, y, c).
struct Part {
  ImageSpec spec;
  float (*value)(int x, int y, int channel);
};

ImageSpec spec_of(int width, int height, const Names& channels, const TypeDesc& type = TypeDesc::FLOAT) {
  ImageSpec spec(width, height, int(channels.size()), type);
  spec.channelnames = channels;
  return spec;
}

float by_channel(int, int, int channel) {
  return 0.25f * float(channel + 1);
}

float by_place(int x, int y, int channel) {
  return float(x + 100 * y + 10000 * channel);
}

std::vector<float> pixels_of(const Part& part) {
  std::vector<float> pixels;
  for (int y = 0; y < part.spec.height; ++y)
    for (int x = 0; x < part.spec.width; ++x)
      for (int c = 0; c < part.spec.nchannels; ++c) pixels.push_back(part.value(x, y, c));
  return pixels;
}

class ExrPictures : public ::testing::Test {
 protected:
  /// Writes the parts as one file.
  void write(const std::vector<Part>& parts) const {
    std::vector<ImageSpec> specs;
    for (const Part& part : parts) specs.push_back(part.spec);
    auto output = OIIO::ImageOutput::create("openexr");
    bool written = specs.size() == 1 ? output->open(file_.string(), specs[0])
                                     : output->open(file_.string(), int(specs.size()), specs.data());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i > 0)
        written = written && output->open(file_.string(), specs[i], OIIO::ImageOutput::AppendSubimage);
      written = written && output->write_image(TypeDesc::FLOAT, pixels_of(parts[i]).data());
    }
    ASSERT_TRUE(written && output->close()) << output->geterror();
  }

  std::vector<float> first_pixel(const std::string& layer = "") const {
    const Image image = read_image(file_, layer);
    return {image.data.begin(), image.data.begin() + image.channels};
  }

  auto reading(const std::string& layer = "") const {
    return [this, layer] { read_image(file_, layer); };
  }

  /// Puts another box into the header.
  void set_window(const std::string& name, std::initializer_list<std::uint32_t> corners) const {
    std::string bytes = read_file(file_), box;
    for (const std::uint32_t corner : corners) box += test::little_endian(corner);
    const std::string start = name + std::string("\0box2i\0\x10\0\0\0", 11);
    const std::size_t place = bytes.find(start);
    ASSERT_NE(place, std::string::npos);
    write_file_atomic(file_, bytes.replace(place + start.size(), box.size(), box));
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "a.exr";
};

TEST_F(ExrPictures, ChannelsAreTakenByTheirNames) {
  write({{spec_of(3, 2, {"Z", "B", "R", "G"}), by_channel}});
  EXPECT_THAT(first_pixel(), ElementsAre(0.75f, 1.0f, 0.5f));
  write({{spec_of(3, 2, {"Y", "right.Y"}), by_channel}});
  EXPECT_THAT(first_pixel(), ElementsAre(0.25f, 0.25f, 0.25f));
  EXPECT_THAT(first_pixel("right"), ElementsAre(0.5f, 0.5f, 0.5f));
}

TEST_F(ExrPictures, AlphaIsThatOfTheLayer) {
  write({{spec_of(3, 2, {"R", "G", "B", "l.R", "l.G", "l.B", "l.A"}, TypeDesc::HALF), by_channel}});
  EXPECT_THAT(first_pixel(), ElementsAre(0.25f, 0.5f, 0.75f));
  EXPECT_THAT(first_pixel("l"), ElementsAre(1.0f, 1.25f, 1.5f, 1.75f));
}

TEST_F(ExrPictures, ChannelsBetweenColourAndAlphaAreLeftOut) {
  write({{spec_of(70, 130, {"R", "G", "B", "Y", "A"}), by_place}});  // more lines than are read at once
  const Image image = read_image(file_);
  EXPECT_THAT(image.pixel(69, 129), ElementsAre(12969, 22969, 32969, 52969));
  EXPECT_THAT(image.pixel(5, 63), ElementsAre(6305, 16305, 26305, 46305));
}

TEST_F(ExrPictures, ChannelsMayHaveSeveralTypes) {
  ImageSpec spec = spec_of(3, 2, {"R", "G", "B", "id"});
  spec.channelformats = {TypeDesc::HALF, TypeDesc::FLOAT, TypeDesc::HALF, TypeDesc::UINT};
  write({{spec, by_channel}});
  EXPECT_THAT(first_pixel(), ElementsAre(0.25f, 0.5f, 0.75f));
}

TEST_F(ExrPictures, WholeNumbersAreNoLight) {
  write({{spec_of(3, 2, {"Y"}, TypeDesc::UINT), by_channel}});
  EXPECT_THAT(reading(), ThrowsMessage<Error>(HasSubstr("the channel 'Y' holds whole numbers")));
}

TEST_F(ExrPictures, PartsAreLayers) {
  Part albedo{spec_of(4, 5, {"R", "G", "B"}), by_channel},
      beauty{spec_of(4, 5, {"R", "G", "B", "A"}), by_place};
  albedo.spec.attribute("oiio:subimagename", "albedo");
  beauty.spec.attribute("oiio:subimagename", "beauty");
  write({albedo, beauty});
  EXPECT_THAT(reading(), ThrowsMessage<Error>(HasSubstr("'albedo', 'beauty'")));
  EXPECT_THAT(read_image(file_, "albedo").pixel(3, 4), ElementsAre(0.25f, 0.5f, 0.75f));
  const Image image = read_image(file_, "beauty");
  EXPECT_THAT(image.pixel(3, 4), ElementsAre(403, 10403, 20403, 30403));
}

TEST_F(ExrPictures, DeepPartsAreNoPictures) {
  ImageSpec left = spec_of(3, 2, {"R", "G", "B"});
  left.deep = true;
  ImageSpec right = left;
  left.attribute("oiio:subimagename", "left");
  right.attribute("oiio:subimagename", "right");
  const ImageSpec specs[] = {left, right};
  auto output = OIIO::ImageOutput::create("openexr");
  ASSERT_TRUE(output->open(file_.string(), 2, specs) && output->write_deep_image(OIIO::DeepData(left)));
  ASSERT_TRUE(output->open(file_.string(), right, OIIO::ImageOutput::AppendSubimage) &&
              output->write_deep_image(OIIO::DeepData(right)) && output->close());
  output.reset();
  EXPECT_THAT(reading(), ThrowsMessage<Error>(HasSubstr("is a deep image")));
}

TEST_F(ExrPictures, TheFinestOfSeveralResolutionsIsRead) {
  ImageSpec spec = spec_of(32, 32, {"R", "G", "B"});
  spec.tile_width = spec.tile_height = 16;
  spec.attribute("textureformat", "Plain Texture");  // with mipmaps
  auto output = OIIO::ImageOutput::create("openexr");
  ASSERT_TRUE(output->open(file_.string(), spec));
  ASSERT_TRUE(output->write_image(TypeDesc::FLOAT, pixels_of({spec, by_place}).data()));
  for (int side = 16; side > 0; side /= 2) {
    ImageSpec level = spec;
    level.width = level.height = level.full_width = level.full_height = side;
    ASSERT_TRUE(output->open(file_.string(), level, OIIO::ImageOutput::AppendMIPLevel)) << output->geterror();
    ASSERT_TRUE(output->write_image(TypeDesc::FLOAT, pixels_of({level, by_channel}).data()));
  }
  ASSERT_TRUE(output->close());
  output.reset();  // only this writes all of the file
  EXPECT_THAT(read_image(file_).pixel(31, 31), ElementsAre(3131, 13131, 23131));
}

/// Data of 6 x 5 whose corner lies at (x, y) of a display of 4 x 3.
Part windowed(int x, int y, const Names& channels = {"R", "G", "B"}) {
  Part part{spec_of(6, 5, channels), by_place};
  part.spec.x = x + 10, part.spec.y = y - 20;
  part.spec.full_x = 10, part.spec.full_y = -20;
  part.spec.full_width = 4, part.spec.full_height = 3;
  return part;
}

TEST_F(ExrPictures, ThePictureIsTheDisplayWindow) {
  for (const int tile : {0, 16}) {
    Part part = windowed(2, 1);
    part.spec.tile_width = part.spec.tile_height = tile;
    write({part});
    const Image image = read_image(file_);
    ASSERT_EQ(image.width, 4);
    ASSERT_EQ(image.height, 3);
    EXPECT_THAT(image.pixel(1, 2), ElementsAre(0, 0, 0)) << "beside the data";
    EXPECT_THAT(image.pixel(2, 0), ElementsAre(0, 0, 0)) << "above the data";
    EXPECT_THAT(image.pixel(2, 1), ElementsAre(0, 10000, 20000));
    EXPECT_THAT(image.pixel(3, 2), ElementsAre(101, 10101, 20101));
  }
}

TEST_F(ExrPictures, DataOutsideTheDisplayIsCut) {
  write({windowed(-2, -1)});
  const Image image = read_image(file_);
  EXPECT_THAT(image.pixel(0, 0), ElementsAre(102, 10102, 20102));
  EXPECT_THAT(image.pixel(3, 2), ElementsAre(305, 10305, 20305));
}

TEST_F(ExrPictures, WithoutDataThereIsNothingToSee) {
  write({windowed(2, 1, {"R", "G", "B", "A"})});
  EXPECT_THAT(read_image(file_).pixel(0, 0), ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(read_image_srgb8(file_).pixel(0, 0), ElementsAre(0, 0, 0, 0));
  EXPECT_THAT(read_image_rgba8(file_).pixel(0, 0), ElementsAre(0, 0, 0, 0));
  write({windowed(4, 3, {"R", "G", "B"})});  // all of it lies outside
  EXPECT_EQ(read_image(file_), Image(4, 3, 3, 0.0f));
  EXPECT_THAT(read_image_rgba8(file_).pixel(0, 0), ElementsAre(0, 0, 0, 255))
      << "black, since it has no alpha";
}

TEST_F(ExrPictures, BothWindowsHaveLimits) {
  for (const char* name : {"dataWindow", "displayWindow"}) {
    write({{spec_of(4, 3, {"R", "G", "B"}), by_channel}});
    set_window(name, {0, 0, 16'777'215, 2});
    EXPECT_THAT(reading(), ThrowsMessage<Error>(HasSubstr("16777216 x 3 pixels is too large"))) << name;
    set_window(name, {0, 0, 16383, 16383});
    EXPECT_THAT(reading(), ThrowsMessage<Error>(HasSubstr("cannot hold 16384 x 16384 pixels"))) << name;
    set_window(name, {5, 5, 4, 4});
    EXPECT_THAT(reading(), ThrowsMessage<Error>(HasSubstr("0 x 0 pixels"))) << name;
  }
}

/// An attribute of a header.
std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
  return name + '\0' + type + '\0' + test::little_endian(std::uint32_t(value.size())) + value;
}

std::string half_channel(const std::string& name, std::uint32_t sampling) {
  return name + '\0' + test::little_endian(1) + test::little_endian(0) + test::little_endian(sampling) +
         test::little_endian(sampling);
}

TEST_F(ExrPictures, SubsampledChannelsAreAnErrorThatSaysSo) {
  const std::string window =
      test::little_endian(0) + test::little_endian(0) + test::little_endian(1) + test::little_endian(1);
  const std::string one("\0\0\x80\x3f", 4);
  std::string bytes("\x76\x2f\x31\x01\x02\0\0\0", 8);
  bytes += attribute("channels", "chlist",
                     half_channel("BY", 2) + half_channel("RY", 2) + half_channel("Y", 1) + '\0');
  bytes += attribute("compression", "compression", std::string(1, '\0'));
  bytes += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window);
  bytes += attribute("lineOrder", "lineOrder", std::string(1, '\0'));
  bytes += attribute("pixelAspectRatio", "float", one) + attribute("screenWindowWidth", "float", one);
  bytes += attribute("screenWindowCenter", "v2f", std::string(8, '\0')) + '\0';
  const auto lines = std::uint32_t(bytes.size() + 16);
  bytes += test::little_endian(lines) + test::little_endian(0) + test::little_endian(lines + 16) +
           test::little_endian(0);
  bytes +=
      test::little_endian(0) + test::little_endian(8) + std::string(8, '\x3c');  // a line of BY, RY and two Y
  bytes += test::little_endian(1) + test::little_endian(4) + std::string(4, '\x3c');  // of two Y
  write_file_atomic(file_, bytes);
  EXPECT_THAT(reading(), ThrowsMessage<Error>(HasSubstr("Subsampled channels")));
}

}  // namespace
}  // namespace lightbench
