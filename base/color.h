#pragma once

#include "base/image.h"

namespace lightbench {

/// IEC 61966-2-1 transfer function, linear 0..1 -> encoded 0..1. Not clamped.
float srgb_encode(float linear);
/// Its inverse, encoded 0..1 -> linear 0..1.
float srgb_decode(float encoded);
/// The linear value of an 8-bit sRGB component, from a table.
float srgb_decode8(std::uint8_t encoded);

/// Clamps to 0..1, encodes the first three components as sRGB and rounds to 8 bits; a fourth component
/// (alpha) is rounded linearly. One- and two-component images are encoded like colour.
/// NaN becomes 0: look for it with `first_non_finite` before.
Image8 to_srgb8(const Image& linear);
/// The inverse of `to_srgb8` but for rounding.
Image from_srgb8(const Image8& encoded);

/// Mean of the linear luminance (Rec. 709) over the pixels, weighted by alpha where there is one; 0 where
/// nothing counts.
double mean_luminance(const Image& linear);

/// Index of the first component that is NaN or infinite, or -1.
std::ptrdiff_t first_non_finite(const Image& image);

/// Mean of factor x factor blocks in linear light; width and height must be multiples of factor.
Image box_downsample(const Image& image, int factor);

}  // namespace lightbench
