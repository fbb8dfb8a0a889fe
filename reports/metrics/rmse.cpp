#include "reports/metrics/rmse.h"

#include <algorithm>
#include <cmath>

namespace lightbench {

MetricValue rmse(const MetricInput& input) {
  // 65,536 squares of at most 65,025 fit in 32 bits.
  constexpr std::size_t kBlock = std::size_t(1) << 16;
  const auto& a = input.reference.data;
  const auto& b = input.image.data;
  std::uint64_t total = 0;
  for (std::size_t begin = 0; begin < a.size(); begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, a.size());
    std::uint32_t sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const int difference = int(a[i]) - int(b[i]);
      sum += std::uint32_t(difference * difference);
    }
    total += sum;
  }
  return MetricValue::of(std::sqrt(double(total) / double(a.size())));
}

}  // namespace lightbench
