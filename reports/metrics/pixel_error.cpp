#include "reports/metrics/pixel_error.h"

namespace lightbench {

ErrorHistogram pixel_errors(const Image8& a, const Image8& b) {
  ErrorHistogram histogram{};
  for (std::size_t pixel = 0; pixel < a.pixel_count(); ++pixel)
    ++histogram[std::size_t(pixel_error(a, b, pixel))];
  return histogram;
}

}  // namespace lightbench
