#pragma once

#include "reports/metric.h"

namespace lightbench {

/// Image-space radiosity thesis, eq. 21, with the baseline as I_1: -1 where the image has the smaller mean
/// error, 1 where the baseline has, 0 where both are equal. Compared as whole numbers, so ties are exact.
MetricValue quality(const MetricInput& input);

}  // namespace lightbench
