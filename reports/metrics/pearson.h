#pragma once

#include "reports/metric.h"

namespace lightbench {

/// Image-space radiosity thesis, eq. 20: the product-moment correlation of all components of all pixels,
/// pooled. Undefined where one of the images is constant. The sums are exact, so equal images give exactly 1.
MetricValue pearson(const MetricInput& input);

}  // namespace lightbench
