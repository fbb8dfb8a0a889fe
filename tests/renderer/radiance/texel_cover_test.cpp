#include "renderer/radiance/texel_cover.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using testing::ElementsAre;
using Corners = std::array<glm::vec2, 3>;

struct Cover {
  std::vector<Corners> coordinates;
  std::vector<std::uint32_t> charts;
  glm::ivec2 size{8, 8};
  std::vector<glm::ivec2> anchors = {};

  TexelCover made() const { return cover_texels({size, coordinates, charts, anchors}); }
};

std::vector<glm::ivec2> places(const std::vector<SurfaceTexel>& texels) {
  std::vector<glm::ivec2> places;
  for (const SurfaceTexel& texel : texels) places.push_back(texel.place);
  return places;
}

TEST(TexelCover, ATexelIsWhereItsCentreIs) {
  const auto cover = Cover{{Corners{{{1.5f, 1.5f}, {3.5f, 1.5f}, {1.5f, 3.5f}}}}, {0}}.made();
  EXPECT_THAT(places(cover.surface), ElementsAre(glm::ivec2(1, 1), glm::ivec2(2, 1), glm::ivec2(3, 1),
                                                 glm::ivec2(1, 2), glm::ivec2(2, 2), glm::ivec2(1, 3)));
  EXPECT_EQ(cover.surface[1].beta, 0.5f);
  EXPECT_EQ(cover.surface[1].gamma, 0);
  EXPECT_EQ(cover.surface[5].gamma, 1);
}

TEST(TexelCover, GuttersGoOnInALine) {
  const auto cover = Cover{{Corners{{{1.5f, 1.5f}, {4.5f, 1.5f}, {1.5f, 4.5f}}}}, {0}}.made();
  ASSERT_EQ(cover.gutters.size(), 3u);
  for (const GutterTexel& gutter : cover.gutters) {
    const glm::ivec2 a = cover.surface[gutter.a].place, c = cover.surface[gutter.c].place;
    EXPECT_EQ(gutter.a, gutter.b);
    EXPECT_EQ(2 * a - c, gutter.place);
  }
}

TEST(TexelCover, TheSmallestHalfCompletesItsSquare) {
  const Cover half{{Corners{{{1.5f, 1.5f}, {2.5f, 1.5f}, {1.5f, 2.5f}}}}, {0}, {8, 8}, {{1, 1}}};
  const auto cover = half.made();
  ASSERT_EQ(cover.gutters.size(), 1u);
  const GutterTexel& g = cover.gutters[0];
  EXPECT_EQ(g.place, glm::ivec2(2, 2));
  EXPECT_EQ(cover.surface[g.c].place, glm::ivec2(1, 1));
  EXPECT_EQ(cover.surface[g.a].place + cover.surface[g.b].place, glm::ivec2(4, 4) - glm::ivec2(1, 1));
}

TEST(TexelCover, WithoutAnAnchorTheNearestMustDo) {
  const auto cover = Cover{{Corners{{{1.5f, 1.5f}, {2.5f, 1.5f}, {1.5f, 2.5f}}}}, {0}}.made();
  ASSERT_EQ(cover.gutters.size(), 1u);
  EXPECT_EQ(cover.gutters[0].a, cover.gutters[0].c);
  EXPECT_EQ(cover.gutters[0].b, cover.gutters[0].c);
}

TEST(TexelCover, BordersBetweenTexelCentresHaveGuttersAround) {
  const Corners half{{{1, 1}, {4, 1}, {1, 4}}}, other{{{4, 4}, {1, 4}, {4, 1}}};
  const auto cover = Cover{{half, other}, {0, 0}}.made();
  EXPECT_EQ(cover.surface.size(), 3u * 3u);
  EXPECT_EQ(cover.gutters.size(), 5u * 5u - 3u * 3u);
}

TEST(TexelCover, ChartsThatMeetInOneTexelAreAProblem) {
  const Corners half{{{1.5f, 1.5f}, {3.5f, 1.5f}, {1.5f, 3.5f}}},
      next{{{3.5f, 1.5f}, {6.5f, 1.5f}, {3.5f, 4.5f}}};
  EXPECT_EQ(*(Cover{{half, next}, {0, 1}}.made().problem),
            "two pieces are too close to each other at texel (3, 1), triangle 1");
  EXPECT_FALSE((Cover{{half, next}, {0, 0}}.made().problem));
}

TEST(TexelCover, OverlapIsAProblemEvenWithinAChart) {
  const Corners half{{{1.5f, 1.5f}, {6.5f, 1.5f}, {1.5f, 6.5f}}};
  EXPECT_EQ(*(Cover{{half, half}, {0, 0}}.made().problem), "triangles 0 and 1 overlap at texel (2, 2)");
}

TEST(TexelCover, AChartBetweenTexelCentresIsAProblem) {
  const Corners small{{{1.6f, 1.6f}, {1.9f, 1.6f}, {1.6f, 1.9f}}};
  EXPECT_EQ(*(Cover{{small}, {0}}.made().problem), "a piece at texel (1, 1) is too small for this size");
}

TEST(TexelCover, TrianglesOfNoChartTakeNoPart) {
  const auto cover = Cover{{Corners{{{1.5f, 1.5f}, {3.5f, 1.5f}, {1.5f, 3.5f}}}}, {kNoChart}}.made();
  EXPECT_TRUE(cover.surface.empty());
  EXPECT_TRUE(cover.gutters.empty());
}

}  // namespace
}  // namespace lightbench
