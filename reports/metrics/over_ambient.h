#pragma once

#include "reports/metric.h"

namespace lightbench {

/// Gain of the fitted ambient light itself, and of the image over it (reports/ambient_fit.h).
MetricValue ambient_fit_gain(const MetricInput& input);
MetricValue over_ambient(const MetricInput& input);

}  // namespace lightbench
