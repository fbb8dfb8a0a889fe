#include "reports/small_font.h"

#include <algorithm>

namespace lightbench {
namespace {

struct Glyph {
  char character;
  std::array<std::string_view, kGlyphHeight> rows;
};

constexpr Glyph kGlyphs[] = {
    {'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "}},
    {'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    {'2', {" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####"}},
    {'3', {" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### "}},
    {'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}},
    {'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}},
    {'6', {" ### ", "#    ", "#    ", "#### ", "#   #", "#   #", " ### "}},
    {'7', {"#####", "    #", "   # ", "  #  ", "  #  ", "  #  ", "  #  "}},
    {'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}},
    {'9', {" ### ", "#   #", "#   #", " ####", "    #", "    #", " ### "}},
    {'.', {"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  "}},
    {'+', {"     ", "  #  ", "  #  ", "#####", "  #  ", "  #  ", "     "}},
    {'-', {"     ", "     ", "     ", "#####", "     ", "     ", "     "}},
    {'o', {"     ", "     ", " ### ", "#   #", "#   #", "#   #", " ### "}},
    {'f', {"  ## ", " #   ", " #   ", "###  ", " #   ", " #   ", " #   "}},
};

void draw_glyph(Image8& image, int x, int y, const Glyph& glyph, int dot,
                const std::array<std::uint8_t, 3>& color) {
  const int left = std::max(x, 0), right = std::min(x + kGlyphWidth * dot, image.width);
  const int top = std::max(y, 0), bottom = std::min(y + kGlyphHeight * dot, image.height);
  for (int row = top; row < bottom; ++row)
    for (int column = left; column < right; ++column)
      if (glyph.rows[std::size_t((row - y) / dot)][std::size_t((column - x) / dot)] == '#')
        std::ranges::copy(color, image.pixel(column, row).begin());
}

}  // namespace

int text_width(std::string_view text, int dot) {
  return text.empty() ? 0 : (int(text.size()) * (kGlyphWidth + 1) - 1) * dot;
}

void draw_text(Image8& image, int x, int y, std::string_view text, int dot,
               const std::array<std::uint8_t, 3>& color) {
  for (const char character : text) {
    const auto* glyph = std::ranges::find(kGlyphs, character, &Glyph::character);
    if (glyph != std::end(kGlyphs)) draw_glyph(image, x, y, *glyph, dot, color);
    x += (kGlyphWidth + 1) * dot;
  }
}

}  // namespace lightbench
