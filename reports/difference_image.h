#pragma once

#include "base/image.h"

namespace lightbench {

/// 255 - |a - b| per component, as in the ISR thesis (figure 5.5): white where equal. Three components.
Image8 difference_image(const Image8& a, const Image8& b);

/// Mean absolute error per pixel through a colour map (dark blue 0 ... red) with a fixed scale, `scale` of 255 and
/// above being its end, and a labelled colour bar below the image, so heights differ from the input's.
Image8 heat_map(const Image8& a, const Image8& b, double scale = 64.0);

}  // namespace lightbench
