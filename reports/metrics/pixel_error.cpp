#include "reports/metrics/pixel_error.h"

#include <algorithm>
#include <cstdlib>

namespace lightbench {

int pixel_error(const Image8& a, const Image8& b, std::size_t pixel) {
  const std::uint8_t* p = a.data.data() + 3 * pixel;
  const std::uint8_t* q = b.data.data() + 3 * pixel;
  return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

ErrorHistogram pixel_errors(const Image8& a, const Image8& b) {
  ErrorHistogram histogram{};
  for (std::size_t pixel = 0; pixel < a.pixel_count(); ++pixel)
    ++histogram[std::size_t(pixel_error(a, b, pixel))];
  return histogram;
}

}  // namespace lightbench
