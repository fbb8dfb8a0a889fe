#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "reports/metrics/block_error.h"

namespace lightbench {

/// Where two pictures differ most. A pixel's error is its largest difference of a component, 0..255.
struct ErrorPlace {
  std::size_t differing = 0;  ///< pixels with any error
  int largest = 0;            ///< the largest error of a pixel
  int x = 0, y = 0;           ///< the first pixel that has it, in reading order; from the top left corner
  PixelBox region{};  ///< around the pixels joined to it, by side or corner, with at least half its error
  std::size_t region_pixels = 0;
  WorstBlock block{};
};

/// Nothing where the pictures are the same. Both have three components and one size.
std::optional<ErrorPlace> find_error(const Image8& a, const Image8& b);

/// The same for people, in whole lines.
std::string error_place_text(const std::optional<ErrorPlace>& place);

}  // namespace lightbench
