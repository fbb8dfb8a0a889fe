#include "renderer/radiance/rectangle_packing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace lightbench {
namespace {

TEST(RectanglePacking, PutsLowOnesIntoTheRoomThatHighOnesLeave) {
  const std::vector<glm::ivec2> sizes{{3, 1}, {7, 4}, {7, 3}, {2, 1}};
  const RectanglePacking packing = pack_on_shelves(sizes, 10);
  EXPECT_EQ(packing.size, glm::ivec2(10, 7));
  EXPECT_EQ(packing.places[0], glm::ivec2(7, 0));
  EXPECT_EQ(packing.places[2], glm::ivec2(0, 4));
  EXPECT_EQ(packing.places[3], glm::ivec2(7, 4));
}

TEST(RectanglePacking, EqualSquaresFillASquare) {
  const std::vector<glm::ivec2> sizes(9, glm::ivec2(5, 5));
  EXPECT_EQ(pack_about_square(sizes).size, glm::ivec2(15, 15));
}

TEST(RectanglePacking, IsAsWideAsItsWidest) {
  const std::vector<glm::ivec2> sizes{{100, 2}};
  EXPECT_EQ(pack_about_square(sizes).size, glm::ivec2(100, 2));
}

TEST(RectanglePacking, OfNothingIsEmpty) {
  EXPECT_EQ(pack_about_square({}).size, glm::ivec2(0, 0));
}

RC_GTEST_PROP(RectanglePacking, RectanglesDoNotOverlap, ()) {
  std::vector<glm::ivec2> sizes(*rc::gen::inRange<std::size_t>(0, 60));
  for (glm::ivec2& size : sizes) size = {*rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20)};
  const RectanglePacking packing = pack_about_square(sizes);
  std::vector<std::uint8_t> taken(std::size_t(packing.size.x) * std::size_t(packing.size.y));
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const glm::ivec2 low = packing.places[i], high = low + sizes[i];
    RC_ASSERT(low.x >= 0 && low.y >= 0 && high.x <= packing.size.x && high.y <= packing.size.y);
    for (int y = low.y; y < high.y; ++y)
      for (int x = low.x; x < high.x; ++x)
        RC_ASSERT(taken[std::size_t(y) * std::size_t(packing.size.x) + std::size_t(x)]++ == 0);
  }
  double area = 0;
  for (const glm::ivec2& size : sizes) area += size.x * size.y;
  // About square, and not much larger than it must be: one shelf has as much room as the largest rectangle.
  RC_ASSERT(std::max(packing.size.x, packing.size.y) <= 1.3 * std::sqrt(area) + 20);
}

}  // namespace
}  // namespace lightbench
