#include "reports/metrics/over_ambient.h"

#include "reports/metrics/gain.h"

namespace lightbench {

MetricValue ambient_fit_gain(const MetricInput& input) {
  return gain({.reference = input.reference, .image = *input.ambient_fit, .baseline = input.baseline});
}

MetricValue over_ambient(const MetricInput& input) {
  const MetricValue value =
      gain({.reference = input.reference, .image = input.image, .baseline = input.ambient_fit});
  return value.value ? value : MetricValue::undefined("the fitted ambient light has no error");
}

}  // namespace lightbench
