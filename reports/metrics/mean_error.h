#pragma once

#include <cstdint>

#include "reports/metric.h"

namespace lightbench {

/// Image-space radiosity thesis, eq. 19: the sum of |a - b| over all pixels and components / (3 w h); 0..255.
MetricValue mean_error(const MetricInput& input);

/// The sum of |a - b| over all pixels and components, exact.
std::uint64_t absolute_error_sum(const Image8& a, const Image8& b);

}  // namespace lightbench
