#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "base/image.h"

namespace lightbench {

/// Digits, '.', '+', '-', space and the letters of "of", 5 x 7 dots each, for labels within images; needs no
/// font file. Anything else is drawn as a space.
inline constexpr int kGlyphWidth = 5;
inline constexpr int kGlyphHeight = 7;

/// Width in pixels of `text` with dots of `dot` x `dot` pixels and one dot between characters.
int text_width(std::string_view text, int dot);

/// Draws from (x, y), the upper left corner, clipped to the image, which has three components.
void draw_text(Image8& image, int x, int y, std::string_view text, int dot,
               const std::array<std::uint8_t, 3>& color);

}  // namespace lightbench
