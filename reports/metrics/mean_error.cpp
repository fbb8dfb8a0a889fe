#include "reports/metrics/mean_error.h"

#include <algorithm>
#include <cstdlib>

namespace lightbench {

std::uint64_t absolute_error_sum(const Image8& a, const Image8& b) {
  // A block's sum fits in 32 bits, so that the inner loop needs no wider lanes.
  constexpr std::size_t kBlock = std::size_t(1) << 16;
  const std::size_t size = std::min(a.data.size(), b.data.size());
  std::uint64_t total = 0;
  for (std::size_t begin = 0; begin < size; begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, size);
    std::uint32_t sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += std::uint32_t(std::abs(int(a.data[i]) - int(b.data[i])));
    total += sum;
  }
  return total;
}

MetricValue mean_error(const MetricInput& input) {
  return MetricValue::of(double(absolute_error_sum(input.reference, input.image)) /
                         double(input.reference.data.size()));
}

}  // namespace lightbench
