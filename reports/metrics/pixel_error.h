#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "base/image.h"

namespace lightbench {

/// The error of one pixel, 0..255: the largest absolute difference of its three components. A break in one
/// component alone thus counts in full, as it does in the largest error over all components.
inline int pixel_error(const Image8& a, const Image8& b, std::size_t pixel) {
  const std::uint8_t* p = a.data.data() + 3 * pixel;
  const std::uint8_t* q = b.data.data() + 3 * pixel;
  return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

/// How many pixels have each error.
using ErrorHistogram = std::array<std::uint64_t, 256>;
ErrorHistogram pixel_errors(const Image8& a, const Image8& b);

}  // namespace lightbench
