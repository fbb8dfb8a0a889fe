#include "reports/metrics/local_error.h"

#include <algorithm>

#include "reports/metrics/pixel_error.h"

namespace lightbench {

MetricValue max_error(const MetricInput& input) {
  const std::uint8_t* a = input.reference.data.data();
  const std::uint8_t* b = input.image.data.data();
  std::uint8_t largest = 0;
  for (std::size_t i = 0; i < input.reference.data.size(); ++i) {
    const std::uint8_t difference = std::uint8_t(a[i] > b[i] ? a[i] - b[i] : b[i] - a[i]);
    largest = std::max(largest, difference);
  }
  return MetricValue::of(largest);
}

MetricValue p99_error(const MetricInput& input) {
  const ErrorHistogram histogram = pixel_errors(input.reference, input.image);
  const std::uint64_t pixels = input.reference.pixel_count();
  std::uint64_t within = 0;
  std::size_t error = 0;
  while (true) {
    within += histogram[error];
    if (100 * within >= 99 * pixels) return MetricValue::of(double(error));
    ++error;
  }
}

MetricValue bad_pixels(const MetricInput& input) {
  const ErrorHistogram histogram = pixel_errors(input.reference, input.image);
  std::uint64_t bad = 0;
  for (std::size_t error = kBadPixelError + 1; error < histogram.size(); ++error) bad += histogram[error];
  return MetricValue::of(100.0 * double(bad) / double(input.reference.pixel_count()));
}

}  // namespace lightbench
