#include "reports/metrics/pearson.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

__extension__ using Int128 = __int128;

struct Sums {
  std::uint64_t a = 0, b = 0, aa = 0, bb = 0, ab = 0;
};

Sums sums_of(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  // 65,536 products of at most 65,025 fit in 32 bits.
  constexpr std::size_t kBlock = std::size_t(1) << 16;
  Sums sums;
  for (std::size_t begin = 0; begin < a.size(); begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, a.size());
    std::uint32_t sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const int x = a[i], y = b[i];
      sum_a += std::uint32_t(x);
      sum_b += std::uint32_t(y);
      sum_aa += std::uint32_t(x * x);
      sum_bb += std::uint32_t(y * y);
      sum_ab += std::uint32_t(x * y);
    }
    sums.a += sum_a;
    sums.b += sum_b;
    sums.aa += sum_aa;
    sums.bb += sum_bb;
    sums.ab += sum_ab;
  }
  return sums;
}

/// n^2 times the covariance of two variables: n sum(xy) - sum(x) sum(y).
Int128 scaled_covariance(std::size_t n, std::uint64_t xy, std::uint64_t x, std::uint64_t y) {
  return Int128(n) * Int128(xy) - Int128(x) * Int128(y);
}

}  // namespace

MetricValue pearson(const MetricInput& input) {
  const std::size_t n = input.reference.data.size();
  const Sums sums = sums_of(input.reference.data, input.image.data);
  const Int128 variance_a = scaled_covariance(n, sums.aa, sums.a, sums.a);
  const Int128 variance_b = scaled_covariance(n, sums.bb, sums.b, sums.b);
  if (variance_a == 0) return MetricValue::undefined("the reference is constant");
  if (variance_b == 0) return MetricValue::undefined("the image is constant");
  const Int128 covariance = scaled_covariance(n, sums.ab, sums.a, sums.b);
  const auto r = static_cast<double>(
      static_cast<long double>(covariance) /
      (std::sqrt(static_cast<long double>(variance_a)) * std::sqrt(static_cast<long double>(variance_b))));
  return MetricValue::of(std::clamp(r, -1.0, 1.0));
}

}  // namespace lightbench
