#pragma once

#include <cstdint>

#include "reports/metric.h"

namespace lightbench {

/// A part of a picture, in pixels; x to the right and y downwards from the top left corner.
struct PixelBox {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool operator==(const PixelBox&) const = default;
};

inline constexpr int kBlockSide = 16;

/// The block of kBlockSide x kBlockSide pixels (less where the picture is smaller) with the largest mean
/// error, wherever it begins; the first in reading order where several have it.
struct WorstBlock {
  PixelBox box;
  double mean_error = 0;  ///< over its pixels and components, of 255
};
WorstBlock worst_block(const Image8& a, const Image8& b);

/// Its mean error. A break of that size shows in it even where single pixels elsewhere are farther off, as
/// they are along edges.
MetricValue block_error(const MetricInput& input);

}  // namespace lightbench
