#include "reports/metrics/closeness.h"

#include <algorithm>
#include <cstdlib>

namespace lightbench {
namespace {

struct Counts {
  std::uint64_t closer = 0, farther = 0;
};

int distance(const std::uint8_t* a, const std::uint8_t* b) {
  return std::abs(int(a[0]) - int(b[0])) + std::abs(int(a[1]) - int(b[1])) + std::abs(int(a[2]) - int(b[2]));
}

Counts count(const MetricInput& input) {
  const std::uint8_t* reference = input.reference.data.data();
  const std::uint8_t* image = input.image.data.data();
  const std::uint8_t* baseline = input.baseline->data.data();
  const std::size_t pixels = input.reference.pixel_count();
  std::uint64_t closer = 0, farther = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const int ours = distance(reference + 3 * i, image + 3 * i);
    const int theirs = distance(reference + 3 * i, baseline + 3 * i);
    closer += ours < theirs;
    farther += ours > theirs;
  }
  return {closer, farther};
}

MetricValue share(std::uint64_t pixels, const MetricInput& input) {
  return MetricValue::of(100.0 * double(pixels) / double(input.reference.pixel_count()));
}

}  // namespace

MetricValue closer_share(const MetricInput& input) {
  return share(count(input).closer, input);
}

MetricValue farther_share(const MetricInput& input) {
  return share(count(input).farther, input);
}

MetricValue equal_share(const MetricInput& input) {
  const Counts counts = count(input);
  return share(input.reference.pixel_count() - counts.closer - counts.farther, input);
}

}  // namespace lightbench
