#include "renderer/techniques/images.h"

#include <filesystem>
#include <limits>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/color.h"
#include "base/error.h"
#include "base/files.h"
#include "base/image_io.h"
#include "renderer/frame_context.h"

namespace lightbench {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class Images : public ::testing::Test {
 protected:
  Images() {
    scene_.name = "hall";
    view_.name = "north";
  }

  Image render(const std::string& pattern = "{scene}-{view}.png", const std::string& layer = "") {
    const Technique technique = images_technique();
    const ParamValues params =
        resolve_params(technique.params, technique.presets, "",
                       {{"pattern", (folder_.path() / pattern).string()}, {"layer", layer}}, "test");
    const FrameRequest request{
        .scene = scene_, .view = view_, .width = 3, .height = 2, .samples = 1, .buffers = {}};
    FrameContext frame(request, nullptr, nullptr);
    technique.render(frame, params);
    return frame.result().image;
  }

  TemporaryFolder folder_;
  Scene scene_;
  View view_;
};

TEST_F(Images, ShowsThePictureOfTheView) {
  Image8 picture(3, 2, 3, 77);
  picture.pixel(2, 1)[0] = 200;
  write_png(folder_.path() / "hall-north.png", picture);
  EXPECT_EQ(first_channels(to_srgb8(render()), 3), picture);
}

TEST_F(Images, IsOpaqueWithoutAlpha) {
  write_png(folder_.path() / "hall-north.png", Image8(3, 2, 3, 77));
  EXPECT_EQ(render().pixel(1, 1)[3], 1);
}

TEST_F(Images, KeepsAlpha) {
  Image8 picture(3, 2, 4, 255);
  picture.pixel(1, 1)[3] = 0;
  write_png(folder_.path() / "hall-north.png", picture);
  EXPECT_EQ(render().pixel(1, 1)[3], 0);
  EXPECT_EQ(render().pixel(0, 1)[3], 1);
}

TEST_F(Images, ShowsColourOverBlack) {
  Image8 picture(3, 2, 4, 255);
  picture.pixel(1, 1)[3] = 0;
  write_png(folder_.path() / "hall-north.png", picture);
  EXPECT_EQ(render().pixel(1, 1)[0], 0);
  EXPECT_EQ(render().pixel(0, 1)[0], 1);
}

TEST_F(Images, TakesTheLayerThatIsNamed) {
  OIIO::ImageSpec spec(3, 2, 2, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"direct.Y", "beauty.Y"};
  auto output = OIIO::ImageOutput::create("openexr");
  ASSERT_TRUE(output->open((folder_.path() / "hall-north.exr").string(), spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, std::vector<float>(12, 0.5f).data()) &&
              output->close());
  EXPECT_EQ(render("{scene}-{view}.exr", "beauty").pixel(0, 0)[1], 0.5f);
  EXPECT_THAT([&] { render("{scene}-{view}.exr"); }, ThrowsMessage<Error>(HasSubstr("'beauty', 'direct'")));
}

TEST_F(Images, TakesExrAsLinearLight) {
  write_exr(folder_.path() / "hall-north.exr", Image(3, 2, 3, 0.25f), PixelType::float32);
  EXPECT_EQ(render("{scene}-{view}.exr").pixel(0, 0)[1], 0.25f);
}

TEST_F(Images, NamesBothSizesWhereTheyDiffer) {
  write_png(folder_.path() / "hall-north.png", Image8(4, 5, 3, 77));
  EXPECT_THAT([&] { render(); }, ThrowsMessage<Error>(::testing::AllOf(HasSubstr("4x5"), HasSubstr("3x2"))));
}

TEST_F(Images, NamesTheMissingFile) {
  EXPECT_THAT([&] { render(); }, ThrowsMessage<Error>(HasSubstr("hall-north.png")));
}

TEST_F(Images, RefusesNan) {
  Image picture(3, 2, 3, 0.25f);
  picture.pixel(1, 1)[2] = std::numeric_limits<float>::quiet_NaN();
  write_exr(folder_.path() / "hall-north.exr", picture, PixelType::float32);
  EXPECT_THAT([&] { render("{scene}-{view}.exr"); }, ThrowsMessage<Error>(HasSubstr("(1, 1)")));
}

TEST(PicturePath, ReplacesTheNames) {
  EXPECT_EQ(picture_path("renders/{scene}/{view}-{view}.png", "hall", "north_1"),
            "renders/hall/north_1-north_1.png");
}

TEST(PicturePath, ANameCannotLeaveItsFolder) {
  EXPECT_EQ(picture_path("r/{scene}/{view}.png", "../etc", ".."), "r/%2E.%2Fetc/%2E..png");
}

TEST(PicturePath, ANameIsNotAPatternItself) {
  EXPECT_EQ(picture_path("{scene}", "{view}", "x"), escape_file_name("{view}"));
}

TEST(PicturePath, ADoubledBraceIsABrace) {
  EXPECT_EQ(picture_path("{{old}/${{x}/{view}.png", "hall", "x"), "{old}/${x}/x.png");
}

TEST(PicturePath, NamesTheNearestWord) {
  EXPECT_THAT([] { picture_path("{veiw}.png", "a", "b"); },
              ThrowsMessage<Error>(HasSubstr("did you mean 'view'")));
  EXPECT_THROW(picture_path("{view", "a", "b"), Error);
}

}  // namespace
}  // namespace lightbench
