#include "base/exr_header.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/image_io.h"

namespace lightbench {
namespace {

using namespace std::string_literals;

const std::string kStart = "\x76\x2f\x31\x01\x02\0\0\0"s;

class ExrHeader : public ::testing::Test {
 protected:
  bool fits(const std::string& bytes) const {
    const auto file = folder_.path() / "a.exr";
    write_file_atomic(file, bytes);
    return read_exr_parts(file).has_value();
  }

  TemporaryFolder folder_;
};

TEST_F(ExrHeader, OfAPictureFits) {
  write_exr(folder_.path() / "b.exr", Image(4, 3, 4, 0.5f), PixelType::half, {{"k", "v"}});
  const auto parts = read_exr_parts(folder_.path() / "b.exr");
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->size(), 1u);
  EXPECT_EQ(parts->front().data_width, 4);
  EXPECT_EQ(parts->front().data_height, 3);
  EXPECT_EQ(parts->front().display_width, 4);
  EXPECT_EQ(parts->front().display_height, 3);
}

TEST_F(ExrHeader, WithAnAttributeBeyondTheFileDoesNotFit) {
  EXPECT_TRUE(fits(kStart + "name\0string\0\x03\0\0\0abc\0"s));
  EXPECT_FALSE(fits(kStart + "name\0string\0\x05\0\0\0abc\0"s));
  EXPECT_FALSE(fits(kStart + "name\0string\0\x03\0\0\x70"s + "abc\0"s)) << "1.8 GB";
  EXPECT_FALSE(fits(kStart + "name\0string\0\xff\xff\xff\xff"s + "abc\0"s)) << "a negative size";
}

TEST_F(ExrHeader, ThatIsCutDoesNotFit) {
  const std::string whole = kStart + "name\0string\0\x03\0\0\0abc\0"s;
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(fits(whole.substr(0, length))) << length;
}

TEST_F(ExrHeader, OfSeveralPartsEndsWithAnEmptyOne) {
  const std::string start = "\x76\x2f\x31\x01\x02\x10\0\0"s, part = "name\0string\0\x03\0\0\0abc\0"s;
  EXPECT_TRUE(fits(start + part + part + "\0"s));
  EXPECT_FALSE(fits(start + part + part));
}

TEST_F(ExrHeader, TellsSizesThatDoNotFitIntoFourBytes) {
  const std::string corners = "\0\0\0\x80\0\0\0\x80\xff\xff\xff\x7f\xff\xff\xff\x7f"s;
  write_file_atomic(folder_.path() / "a.exr", kStart + "dataWindow\0box2i\0\x10\0\0\0"s + corners + "\0"s);
  EXPECT_EQ(read_exr_parts(folder_.path() / "a.exr")->front().data_width, std::int64_t(1) << 32);
}

}  // namespace
}  // namespace lightbench
