#include "reports/difference_image.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "reports/metric.h"
#include "reports/small_font.h"

namespace lightbench {
namespace {

using Color = std::array<std::uint8_t, 3>;

/// CIELAB lightness 0 to 97 in equal steps, each with about the largest chroma that sRGB has at its hue.
constexpr Color kStops[] = {{0, 0, 0},      {2, 22, 60},    {6, 28, 116},   {89, 5, 143},   {141, 9, 120},
                            {185, 14, 98},  {226, 20, 75},  {252, 63, 48},  {253, 116, 52}, {253, 155, 58},
                            {254, 190, 64}, {255, 221, 98}, {255, 247, 209}};
constexpr Color kBarBackground{24, 24, 24};
constexpr Color kBarText{235, 235, 235};

int absolute_difference(std::uint8_t a, std::uint8_t b) {
  return std::abs(int(a) - int(b));
}

/// One dot of the bar's labels, in pixels: legible in a picture scaled down to a report's thumbnail column.
int label_dot(int width) {
  return std::clamp(width / 320, 1, 16);
}

struct BarLayout {
  int dot, margin, bar_top, bar_bottom, text_top, height;
};

BarLayout bar_layout(int width) {
  const int dot = label_dot(width);
  return {dot, 3 * dot, 3 * dot, 11 * dot, 13 * dot, 23 * dot};
}

void draw_bar(Image8& image, int top, double scale) {
  const BarLayout layout = bar_layout(image.width);
  for (int y = top; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::ranges::copy(kBarBackground, image.pixel(x, y).begin());

  const int left = std::min(layout.margin, image.width / 4);
  const int right = image.width - left;
  const double span = std::max(1, right - left - 1);
  for (int x = left; x < right; ++x) {
    const Color color = heat_color((x - left) / span);
    for (int y = layout.bar_top; y < layout.bar_bottom; ++y)
      std::ranges::copy(color, image.pixel(x, top + y).begin());
  }

  // Labels that would touch are left out: the two ends first come first served, then the middle, then the
  // quarters.
  std::vector<std::pair<int, int>> taken;
  for (const double part : {0.0, 1.0, 0.5, 0.25, 0.75}) {
    const std::string text =
        part == 1.0 ? fmt::format("{:g}+ of 255", scale) : fmt::format("{:g}", part * scale);
    const int width = text_width(text, layout.dot);
    const int centre = left + int(std::lround(part * span));
    const int x = std::clamp(centre - width / 2, left, std::max(left, right - width));
    const int gap = 2 * layout.dot;
    const bool free = std::ranges::none_of(
        taken, [&](const auto& other) { return x < other.second + gap && other.first < x + width + gap; });
    if (!free || width > right - left) continue;
    taken.emplace_back(x, x + width);
    draw_text(image, x, top + layout.text_top, text, layout.dot, kBarText);
  }
}

}  // namespace

Image8 difference_image(const Image8& a, const Image8& b) {
  check_pair(a, b, "the first image", "the second image");
  Image8 result(a.width, a.height, 3);
  for (std::size_t i = 0; i < result.data.size(); ++i)
    result.data[i] = std::uint8_t(255 - absolute_difference(a.data[i], b.data[i]));
  return result;
}

std::array<std::uint8_t, 3> heat_color(double value) {
  const double position = std::clamp(value, 0.0, 1.0) * double(std::size(kStops) - 1);
  const std::size_t below = std::min(std::size_t(position), std::size(kStops) - 2);
  const double fraction = position - double(below);
  Color color;
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = std::uint8_t(std::lround(std::lerp(kStops[below][c], kStops[below + 1][c], fraction)));
  return color;
}

int heat_bar_height(int width) {
  return bar_layout(width).height;
}

Image8 heat_map(const Image8& a, const Image8& b, double scale) {
  check_pair(a, b, "the first image", "the second image");
  // The sum over three components has 766 values, so a table has all colours.
  std::array<Color, 3 * 255 + 1> colors;
  for (std::size_t sum = 0; sum < colors.size(); ++sum) colors[sum] = heat_color(double(sum) / (3.0 * scale));

  Image8 result(a.width, a.height + heat_bar_height(a.width), 3);
  for (std::size_t i = 0; i < a.data.size(); i += 3) {
    int sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += absolute_difference(a.data[i + c], b.data[i + c]);
    std::ranges::copy(colors[std::size_t(sum)], result.data.begin() + std::ptrdiff_t(i));
  }
  draw_bar(result, a.height, scale);
  return result;
}

}  // namespace lightbench
