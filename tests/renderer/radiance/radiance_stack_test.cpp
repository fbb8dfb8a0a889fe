#include "renderer/radiance/radiance_stack.h"

#include <glm/gtc/packing.hpp>
#include <gmock/gmock.h>

namespace lightbench {
namespace {

using ::testing::ElementsAre;

TEST(RadianceStack, TexelsRunAlongXThenYThenLayer) {
  const ByteStack stack{4, 3, {2, 2}, 1, {}};
  EXPECT_EQ(stack.index(0, 0, 0), 0u);
  EXPECT_EQ(stack.index(1, 0, 0), 1u);
  EXPECT_EQ(stack.index(0, 1, 0), 4u);
  EXPECT_EQ(stack.index(0, 0, 1), 12u);
}

TEST(RadianceStack, BytesAreEncodedAndClamped) {
  const auto half = [](float v) { return glm::packHalf1x16(v); };
  const HalfStack stack{1, 1, {2, 1}, 2, {{half(0), half(0.5f), half(1)}, {half(7), half(0.002f), half(0)}}};
  const ByteStack bytes = to_bytes(stack);
  EXPECT_THAT(bytes.texels[0], ElementsAre(0, 188, 255));  // 255 * srgb(0.5) = 187.5
  EXPECT_THAT(bytes.texels[1], ElementsAre(255, 7, 0));    // 255 * 12.92 * 0.002 = 6.6
  EXPECT_EQ(bytes.scale, 2) << "the radiance of 1 stays what it was";
}

}  // namespace
}  // namespace lightbench
