#pragma once

#include "reports/metric.h"

namespace lightbench {

/// The share of pixels, in percent, whose sum of |a - b| over the three components is strictly smaller than,
/// strictly larger than, or equal to the baseline's at the same place. The three add up to 100.
MetricValue closer_share(const MetricInput& input);
MetricValue farther_share(const MetricInput& input);
MetricValue equal_share(const MetricInput& input);

}  // namespace lightbench
