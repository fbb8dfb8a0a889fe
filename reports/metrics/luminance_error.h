#pragma once

#include "reports/metric.h"

namespace lightbench {

/// The mean of |lum(a) - lum(b)| with lum = 0.27 R + 0.67 G + 0.06 B of the 8-bit values (Image-space
/// radiosity thesis, eq. 17); 0..255.
MetricValue luminance_error(const MetricInput& input);

}  // namespace lightbench
