#include "reports/metrics/flicker.h"

#include <cstdlib>

namespace lightbench {
namespace {

bool counts(const std::vector<std::uint8_t>* mask, std::size_t pixel) {
  return !mask || (*mask)[pixel] != 0;
}

}  // namespace

MetricValue flicker(const MetricInput& input) {
  const PreviousFrame& previous = *input.previous;
  std::uint64_t sum = 0;
  std::uint64_t components = 0;
  for (std::size_t pixel = 0; pixel < input.reference.pixel_count(); ++pixel) {
    if (!counts(input.mask, pixel) || !counts(previous.mask, pixel)) continue;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const int error = int(input.image.data[i]) - int(input.reference.data[i]);
      const int error_before = int(previous.image.data[i]) - int(previous.reference.data[i]);
      sum += std::uint64_t(std::abs(error - error_before));
    }
    components += 3;
  }
  if (components == 0) return MetricValue::undefined("no pixel is of an object in both frames");
  return MetricValue::of(double(sum) / double(components));
}

}  // namespace lightbench
