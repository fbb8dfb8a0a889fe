#pragma once

#include "reports/metric.h"

namespace lightbench {

/// 100 (e_baseline - e) / e_baseline of the mean errors, in percent: 100 is the reference itself, 0 as good
/// as the baseline, negative worse. Undefined over a baseline without error.
MetricValue gain(const MetricInput& input);

}  // namespace lightbench
