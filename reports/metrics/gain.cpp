#include "reports/metrics/gain.h"

#include "reports/metrics/mean_error.h"

namespace lightbench {

MetricValue gain(const MetricInput& input) {
  const std::uint64_t before = absolute_error_sum(input.reference, *input.baseline);
  if (before == 0) return MetricValue::undefined("the baseline has no error");
  const std::uint64_t after = absolute_error_sum(input.reference, input.image);
  return MetricValue::of(100.0 * (double(before) - double(after)) / double(before));
}

}  // namespace lightbench
