#include "renderer/shader_log.h"

#include <gtest/gtest.h>

namespace lightbench {
namespace {

const std::vector<std::string> kFiles = {"direct.frag", "lights.glsl"};

TEST(ShaderLog, PlacesAreNamed) {
  EXPECT_EQ(with_file_names("1:17(3): error: no such name\n0:2: x", kFiles),
            "lights.glsl:17(3): error: no such name\ndirect.frag:2: x");
  EXPECT_EQ(with_file_names("0(17) : error C1008\n", kFiles), "direct.frag:17 : error C1008\n");
  EXPECT_EQ(with_file_names("ERROR: 1:5: x\nWARNING: 0:1: y", kFiles), "lights.glsl:5: x\ndirect.frag:1: y");
}

TEST(ShaderLog, OtherTextStays) {
  for (const char* text : {"", "\n", "error: 1:2", "7 errors", "12:", "ERROR: x", "-1:2"})
    EXPECT_EQ(with_file_names(text, kFiles), text);
  EXPECT_EQ(with_file_names("7:3: x", kFiles), "7:3: x");
}

TEST(ShaderLog, LongLinesAndNumbersAreNoTrouble) {
  const std::string line = "0:1: " + std::string(8'000'000, 'x');
  EXPECT_EQ(with_file_names(line, kFiles).size(), line.size() + kFiles[0].size() - 1);
  const std::string digits(8'000'000, '9');
  EXPECT_EQ(with_file_names(digits + ":1", kFiles), digits + ":1");
}

}  // namespace
}  // namespace lightbench
