#pragma once

#include "reports/metric.h"

namespace lightbench {

/// Water caustics thesis, eq. 2-9: the mean over the mask's pixels of the Euclidean distance in CIE 1976
/// L*u*v*, sRGB with D65 as white. Black, whose chromaticity is not defined, has the white point's. 0 to
/// 274.6 (green to magenta); red to blue is 250.4. Undefined where the mask is empty.
MetricValue luv(const MetricInput& input);

/// L*, u*, v* of one sRGB colour, in double precision: what `luv` computes faster.
struct Luv {
  double l = 0, u = 0, v = 0;
};
Luv to_luv(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

}  // namespace lightbench
