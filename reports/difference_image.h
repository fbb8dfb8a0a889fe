#pragma once

#include <array>
#include <cstdint>

#include "base/image.h"

namespace lightbench {

/// 255 - |a - b| per component, as in the Image-space radiosity thesis (figure 5.5): white where equal. Three
/// components. Works on any two images of one size and three components, such as isolated indirect light;
/// others are an Error.
Image8 difference_image(const Image8& a, const Image8& b);

/// Mean absolute error per pixel through `heat_color` with a fixed scale: black where equal, `scale` of 255
/// and above being the map's end. A labelled colour bar of `heat_bar_height` rows stands below the image.
Image8 heat_map(const Image8& a, const Image8& b, double scale = 64.0);

/// Rows that `heat_map` adds to an image of this width.
int heat_bar_height(int width);

/// The colour map, 0..1 (clamped) to sRGB: black, blue, violet, red, orange, pale yellow, with a lightness
/// that rises evenly, so that it also reads in grey.
std::array<std::uint8_t, 3> heat_color(double value);

}  // namespace lightbench
