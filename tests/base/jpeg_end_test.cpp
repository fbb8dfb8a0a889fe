#include "base/jpeg_end.h"

#include <gtest/gtest.h>

#include "image_samples.h"

namespace lightbench {
namespace {

using namespace std::string_literals;

TEST(JpegEnd, AWholeFileReachesItAndACutOneDoesNot) {
  const std::string bytes = test::encoded("jpeg", test::picture());
  EXPECT_TRUE(reaches_jpeg_end(bytes));
  EXPECT_TRUE(reaches_jpeg_end(bytes + "something after it"));
  for (std::size_t length = 0; length < bytes.size(); ++length)
    ASSERT_FALSE(reaches_jpeg_end(bytes.substr(0, length))) << length;
}

TEST(JpegEnd, TheEndOfAThumbnailWithinASegmentIsNotIt) {
  const std::string start = "\xff\xd8", thumbnail = "\xff\xd8..\xff\xd9";
  const std::string segment = "\xff\xe1"s + '\0' + char(2 + thumbnail.size()) + thumbnail;
  EXPECT_FALSE(reaches_jpeg_end(start + segment));
  EXPECT_TRUE(reaches_jpeg_end(start + segment + "\xff\xd9"));
}

TEST(JpegEnd, StuffedBytesRestartsAndFillsArePassed) {
  EXPECT_TRUE(reaches_jpeg_end("\xff\xd8" + "ab\xff\0cd\xff\xd0"s + "ef\xff\xff\xff\xd9"));
}

}  // namespace
}  // namespace lightbench
