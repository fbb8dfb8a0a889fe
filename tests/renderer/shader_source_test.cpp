#include "renderer/shader_source.h"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

namespace lightbench {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(ShaderSource, EveryEmbeddedShaderExpands) {
  ASSERT_FALSE(embedded_shaders().empty());
  for (const EmbeddedShader& shader : embedded_shaders())
    EXPECT_EQ(count_of(shader_source(shader.name), "#include"), 0u) << shader.name;
}

TEST(ShaderSource, AFileIsIncludedOnce) {
  // direct.frag.glsl reaches frame.glsl through gbuffer.glsl, and the noise of repeated blocks would not
  // compile.
  EXPECT_EQ(count_of(shader_source("shaders/direct.frag.glsl"), "uniform Frame"), 1u);
}

TEST(ShaderSource, NumberedLinesLeadBackToTheFiles) {
  const NumberedShader shader = numbered_shader_source("shaders/gbuffer.glsl");
  ASSERT_GE(shader.files.size(), 2u);
  EXPECT_EQ(shader.files[0], "shaders/gbuffer.glsl");
  EXPECT_NE(std::find(shader.files.begin(), shader.files.end(), "shaders/frame.glsl"), shader.files.end());
  EXPECT_NE(shader.text.find("#line 1 0\n"), std::string::npos);
  EXPECT_NE(shader.text.find("#line 1 1\n"), std::string::npos);
}

TEST(ShaderSource, AnUnknownNameIsABug) {
  EXPECT_THROW(shader_source("shaders/none.glsl"), std::logic_error);
}

}  // namespace
}  // namespace lightbench
