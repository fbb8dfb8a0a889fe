#include "renderer/gl_objects.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "renderer/gl_context.h"
#include "renderer/gl_program.h"

namespace lightbench {
namespace {

class GlObjects : public testing::Test {
 protected:
  std::unique_ptr<GlContext> context = make_gl_context(GlBackend::osmesa);
  void TearDown() override { EXPECT_NO_THROW(context->check("the test")); }
};

Image numbered_image(int width, int height, int channels) {
  Image image(width, height, channels);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = float(i);
  return image;
}

TEST_F(GlObjects, AnUploadedImageIsReadBackTheSame) {
  for (const auto& [format, channels] :
       {std::pair{TexelFormat::r32f, 1}, {TexelFormat::rg32f, 2}, {TexelFormat::rgba32f, 4}}) {
    const Image image = numbered_image(5, 3, channels);
    GlTexture texture(format, 5, 3);
    texture.upload(image);
    EXPECT_EQ(read_back(texture, channels), image);
  }
}

TEST_F(GlObjects, MovingLeavesNothingBehind) {
  GlTexture first(TexelFormat::r8, 2, 2);
  const unsigned id = first.id();
  const GlTexture second = std::move(first);
  EXPECT_EQ(second.id(), id);
  EXPECT_EQ(first.id(), 0u);  // NOLINT: the state after a move is what is tested
}

TEST_F(GlObjects, ATextureTooLargeForMemoryIsAnError) {
  // 2048 layers of 16384 x 16384 x 16 bytes are 8 TiB.
  EXPECT_THROW(GlTexture::array(TexelFormat::rgba32f, 16384, 16384, 2048), Error);
  context->forget_complaints();
}

TEST_F(GlObjects, ACompileErrorNamesTheFileAndLine) {
  try {
    const Program program("shaders/fullscreen.vert.glsl", "shaders/ambient.frag.glsl", {"albedo ]"});
    FAIL();
  } catch (const std::logic_error& error) {
    EXPECT_NE(std::string(error.what()).find("shaders/ambient.frag.glsl:8"), std::string::npos)
        << error.what();
  }
}

TEST_F(GlObjects, AMistakeIsReportedWithItsPlace) {
  GlTexture(TexelFormat::r8, 2, 2).bind(100000);  // there is no such unit
  EXPECT_THROW(context->check("a wrong unit"), std::logic_error);
}

TEST_F(GlObjects, TheContextDescribesItself) {
  EXPECT_EQ(context->description().rfind("osmesa, ", 0), 0u) << context->description();
  EXPECT_GE(context->max_texture_size(), 4096);
}

}  // namespace
}  // namespace lightbench
