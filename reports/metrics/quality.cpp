#include "reports/metrics/quality.h"

#include "reports/metrics/mean_error.h"

namespace lightbench {

MetricValue quality(const MetricInput& input) {
  const std::uint64_t baseline = absolute_error_sum(input.reference, *input.baseline);
  const std::uint64_t image = absolute_error_sum(input.reference, input.image);
  if (image == baseline) return MetricValue::of(0);
  return MetricValue::of(image < baseline ? -1 : 1);
}

}  // namespace lightbench
