#include "base/image_layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace lightbench {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

using Names = std::vector<std::string>;

std::vector<int> indices(const Names& channels, const std::string& layer = "") {
  return find_picture({{"", channels}}, layer, "a.exr").indices;
}

TEST(ImageLayers, ColourIsFoundByItsNames) {
  EXPECT_THAT(indices({"A", "B", "G", "R"}), ElementsAre(3, 2, 1, 0));
  EXPECT_THAT(indices({"Z", "b", "g", "r"}), ElementsAre(3, 2, 1));
  EXPECT_THAT(indices({"Blue", "green", "RED", "alpha"}), ElementsAre(2, 1, 0, 3));
  EXPECT_THAT(indices({"A", "Y"}), ElementsAre(1, 0));
  EXPECT_THAT(indices({"luminance"}), ElementsAre(0));
}

TEST(ImageLayers, AFourthChannelIsNoAlphaUnlessItIsCalledSo) {
  for (const char* name : {"Z", "depth", "right.A", "AR", "channel3", "mask"}) {
    const PictureChannels picture = find_picture({{"", {"R", "G", "B", name}}}, "", "a.exr");
    EXPECT_FALSE(picture.has_alpha) << name;
    EXPECT_THAT(picture.indices, ElementsAre(0, 1, 2)) << name;
  }
}

TEST(ImageLayers, TheLayerWithoutANameIsThePicture) {
  EXPECT_THAT(indices({"Y", "right.Y"}), ElementsAre(0));
  EXPECT_THAT(indices({"albedo.R", "albedo.G", "albedo.B", "R", "G", "B"}), ElementsAre(3, 4, 5));
}

TEST(ImageLayers, TheOnlyLayerWithColourIsThePicture) {
  EXPECT_THAT(indices({"Z", "beauty.R", "beauty.G", "beauty.B", "beauty.A", "A"}), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(
      indices({"View Layer.Combined.R", "View Layer.Combined.G", "View Layer.Combined.B",
               "View Layer.Normal.X", "View Layer.Normal.Y", "View Layer.Normal.Z", "motion.R", "motion.G"}),
      ElementsAre(0, 1, 2));
}

TEST(ImageLayers, SeveralLayersAreNamedToChooseFrom) {
  const Names channels{"albedo.R", "albedo.G", "albedo.B", "beauty.R", "beauty.G", "beauty.B", "depth.Z"};
  EXPECT_THAT([&] { indices(channels); },
              ThrowsMessage<Error>(
                  AllOf(HasSubstr("a.exr"), HasSubstr("'albedo', 'beauty'"), Not(HasSubstr("depth")))));
  EXPECT_THAT(indices(channels, "beauty"), ElementsAre(3, 4, 5));
  EXPECT_THAT([&] { indices(channels, "beuty"); }, ThrowsMessage<Error>(HasSubstr("did you mean 'beauty'")));
  EXPECT_THAT([&] { indices(channels, "depth"); },
              ThrowsMessage<Error>(HasSubstr("no layer 'depth' with colour")));
}

TEST(ImageLayers, AFileWithoutNamedLayersHasOnePicture) {
  EXPECT_THAT(indices({"R", "G", "B"}, "beauty"), ElementsAre(0, 1, 2));
}

TEST(ImageLayers, ALongListEnds) {
  Names channels;
  for (int i = 0; i < 100; ++i) channels.push_back("layer" + std::to_string(i) + ".Y");
  EXPECT_THAT([&] { indices(channels); }, ThrowsMessage<Error>(HasSubstr("'layer19' and 80 more")));
}

TEST(ImageLayers, WithoutColourTheChannelsAreNamed) {
  EXPECT_THAT(
      [] {
        indices({"N.X", "N.Y", "N.Z", "R"});
      },
      ThrowsMessage<Error>(AllOf(HasSubstr("no colour"), HasSubstr("'N.X', 'N.Y', 'N.Z', 'R'"))));
}

TEST(ImageLayers, LuminanceWithChromaIsNoGrey) {
  EXPECT_THAT([] { indices({"Y", "RY", "BY"}); }, ThrowsMessage<Error>(HasSubstr("chroma")));
}

TEST(ImageLayers, PartsAreLayers) {
  const std::vector<FilePart> parts{{"depth", {"Z"}},
                                    {"albedo", {"R", "G", "B"}},
                                    {"beauty", {"beauty.R", "beauty.G", "beauty.B", "beauty.A"}}};
  EXPECT_THAT([&] { find_picture(parts, "", "a.exr"); },
              ThrowsMessage<Error>(HasSubstr("'albedo', 'beauty'")));
  EXPECT_EQ(find_picture(parts, "albedo", "a.exr").part, 1u);
  const PictureChannels beauty = find_picture(parts, "beauty", "a.exr");
  EXPECT_EQ(beauty.part, 2u);
  EXPECT_THAT(beauty.indices, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(find_picture({parts[0], parts[1]}, "", "a.exr").part, 1u) << "the only one with colour";
  const std::vector<FilePart> named{{"left", {"diffuse.Y"}}, {"right", {"diffuse.Y"}}};
  EXPECT_EQ(find_picture(named, "right.diffuse", "a.exr").part, 1u);
}

TEST(ImageLayers, TheNameOfAnOnlyPartIsNoLayer) {
  EXPECT_THAT(find_picture({{"rgba", {"R", "G", "B", "beauty.Y"}}}, "", "a.exr").indices,
              ElementsAre(0, 1, 2));
}

}  // namespace
}  // namespace lightbench
