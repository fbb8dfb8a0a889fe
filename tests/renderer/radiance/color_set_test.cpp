#include "renderer/radiance/color_set.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using ::testing::ElementsAre;

TEST(ColorSet, NumbersDistinctColorsInRisingOrder) {
  const std::vector<Rgb8> colors{{255, 255, 255}, {0, 0, 1}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 64}};
  const ColorSet set(colors);
  EXPECT_THAT(set.colors(),
              ElementsAre(Rgb8{0, 0, 0}, Rgb8{0, 0, 1}, Rgb8{0, 0, 64}, Rgb8{1, 0, 0}, Rgb8{255, 255, 255}));
  EXPECT_EQ(set.size(), 5u);
  for (std::uint32_t i = 0; i < set.size(); ++i) EXPECT_EQ(set.number(set.colors()[i]), i);
}

}  // namespace
}  // namespace lightbench
