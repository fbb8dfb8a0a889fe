#pragma once

#include "reports/metric.h"

namespace lightbench {

/// The square root of the mean of (a - b)^2 over all pixels and components; 0..255.
MetricValue rmse(const MetricInput& input);

}  // namespace lightbench
