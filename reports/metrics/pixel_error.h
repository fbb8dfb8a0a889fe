#pragma once

#include <array>
#include <cstdint>

#include "base/image.h"

namespace lightbench {

/// The error of one pixel, 0..255: the largest absolute difference of its three components. A break in one
/// component alone thus counts in full, as it does in the largest error over all components.
int pixel_error(const Image8& a, const Image8& b, std::size_t pixel);

/// How many pixels have each error.
using ErrorHistogram = std::array<std::uint64_t, 256>;
ErrorHistogram pixel_errors(const Image8& a, const Image8& b);

}  // namespace lightbench
