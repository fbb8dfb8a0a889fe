#include "reports/metrics/luminance_error.h"

#include <algorithm>
#include <cstdlib>

namespace lightbench {

MetricValue luminance_error(const MetricInput& input) {
  // In hundredths, so that sums are exact; a block of at most 25,500 a pixel fits in 32 bits.
  constexpr int kRed = 27, kGreen = 67, kBlue = 6;
  constexpr std::size_t kBlock = std::size_t(1) << 16;
  const std::uint8_t* a = input.reference.data.data();
  const std::uint8_t* b = input.image.data.data();
  const std::size_t pixels = input.reference.pixel_count();
  std::uint64_t total = 0;
  for (std::size_t begin = 0; begin < pixels; begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, pixels);
    std::uint32_t sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t at = 3 * i;
      sum += std::uint32_t(std::abs(kRed * (int(a[at]) - int(b[at])) +
                                    kGreen * (int(a[at + 1]) - int(b[at + 1])) +
                                    kBlue * (int(a[at + 2]) - int(b[at + 2]))));
    }
    total += sum;
  }
  return MetricValue::of(double(total) / (100.0 * double(pixels)));
}

}  // namespace lightbench
