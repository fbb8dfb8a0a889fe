#include "base/image_kinds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image_io.h"
#include "image_samples.h"

namespace lightbench {
namespace {

using namespace std::string_literals;
using ::testing::AllOf;
using ::testing::HasSubstr;

class ImageKinds : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    write_file_atomic(folder_.path() / name, bytes);
    return folder_.path() / name;
  }

  static std::string error_of(const std::filesystem::path& file) {
    try {
      image_kind(file);
    } catch (const Error& error) {
      EXPECT_EQ(error.where(), file.string());
      return error.message();
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

TEST_F(ImageKinds, ContentDecidesAndNotTheName) {
  for (const std::string& format : test::kReadFormats) {
    const auto file = write(test::file_name(format), test::encoded(format, test::picture()));
    EXPECT_STREQ(image_kind(file).reader, format.c_str());
  }
  EXPECT_STREQ(image_kind(write("really_a_png.tga", test::encoded("png", test::picture()))).name, "PNG");
  EXPECT_STREQ(image_kind(write("a.pfm", "Pf\n1 1\n-1.0\n\0\0\0\0"s)).name, "PFM");
}

TEST_F(ImageKinds, TheDocumentationListsThemAll) {
  EXPECT_THAT(read_file(std::filesystem::path(LIGHTBENCH_SOURCE_DIR) / "jobs/FORMAT.md"),
              HasSubstr("are files of " + image_kind_names() + "."));
}

TEST_F(ImageKinds, ForeignFormatsAreNamed) {
  const std::pair<const char*, std::string> files[] = {
      {"GIF", "GIF89a\1\0\1\0\0\0\0"s},
      {"IFF", "FOR4\0\0\0\x20"s + "CIMG"},
      {"DPX", "SDPX\0\0\x08\0"s},
      {"Photoshop", "8BPS\0\1"s},
      {"JPEG 2000", "\0\0\0\x0cjP  \r\n"s},
      {"HEIF or AVIF", "\0\0\0\x1c"s + "ftypavif"},
      {"ICO", "\0\0\1\0\1\0\x10\x10"s},
      {"DDS", "DDS |\0\0\0"s},
      {"XML", "<?xml version=\"1.0\"?><svg/>"},
  };
  for (const auto& [format, bytes] : files)
    EXPECT_THAT(error_of(write("x.png", bytes)),
                AllOf(HasSubstr("in the format "s + format), HasSubstr("reads PNG, JPEG, OpenEXR, TGA")));
}

TEST_F(ImageKinds, WhatIsNoPictureIsAnError) {
  EXPECT_THAT(error_of(write("x.png", "just text")),
              HasSubstr("in no image format that lightbench reads (PNG"));
  EXPECT_THAT(error_of(write("x.png", "")), HasSubstr("is empty"));
  EXPECT_THAT(error_of(folder_.path() / "none.png"), HasSubstr("no such file"));
  EXPECT_THAT(error_of(folder_.path()), HasSubstr("is a folder"));
}

TEST_F(ImageKinds, OnlyRegularFilesAreOpened) {
  const auto pipe = folder_.path() / "pipe.png";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(error_of(pipe), HasSubstr("not a regular file"));  // and nobody waits for its other end
  EXPECT_THAT(error_of("/dev/zero"), HasSubstr("not a regular file"));
}

TEST_F(ImageKinds, ATgaNeedsItsNameAndAHeaderThatMakesSense) {
  const std::string bytes = test::encoded("targa", test::picture());
  EXPECT_STREQ(image_kind(write("a.TGA", bytes)).name, "TGA");
  EXPECT_THAT(error_of(write("a.png", bytes)), HasSubstr("in no image format"));
  for (const auto& [place, value] : {std::pair{1, 2}, {2, 0}, {2, 32}, {12, 0}, {16, 7}}) {
    std::string damaged = bytes;
    damaged[std::size_t(place)] = char(value);
    EXPECT_THAT(error_of(write("a.tga", damaged)), HasSubstr("in no image format")) << place << " " << value;
  }
  EXPECT_THAT(error_of(write("a.tga", bytes.substr(0, 17))), HasSubstr("in no image format"));
}

}  // namespace
}  // namespace lightbench
