#pragma once

#include <array>

#include "base/image.h"

namespace lightbench {

/// The best that a constant ambient light could do: no technique is worth its cost that does worse.
struct AmbientFit {
  std::array<double, 3> irradiance;  ///< linear, not negative
  Image8 image;                      ///< direct + albedo * irradiance, 8-bit sRGB, three components
};

/// Fits the ambient light of each component by itself, so that the mean absolute difference from the
/// reference (8-bit sRGB, three components) is least. `direct` and `albedo` are linear, of the same size,
/// with at least three components. Throws Error where sizes differ.
AmbientFit fit_ambient(const Image& direct, const Image& albedo, const Image8& reference);

}  // namespace lightbench
