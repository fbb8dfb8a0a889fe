#pragma once

#include <cstdint>

#include "renderer/radiance/color_set.h"

namespace lightbench {

/// The colours of `interpolate` from a to b in `length` steps, one after the other and without divisions.
///
/// A division by n of 0 <= x < 256 n is a product with floor(2^40 / n) + 1, less 40 bits: that factor is too
/// large by at most 1, which makes x / n too large by less than 256 n / 2^40, and that is less than 1 / n,
/// the least by which x / n misses a whole number, as long as n < 2^16.
class Ramp {
 public:
  /// length is 1 to 65535
  Ramp(const Rgb8& a, const Rgb8& b, int length) {
    const std::int64_t reciprocal = (std::int64_t{1} << kBits) / length + 1;
    for (std::size_t c = 0; c < 3; ++c) {
      value_[c] = (std::int64_t{a[c]} * length + length / 2) * reciprocal;
      step_[c] = (std::int64_t{b[c]} - a[c]) * reciprocal;
    }
  }

  void step() {
    for (std::size_t c = 0; c < 3; ++c) value_[c] += step_[c];
  }
  int component(std::size_t c) const { return int(value_[c] >> kBits); }
  Rgb8 color() const {
    return {std::uint8_t(component(0)), std::uint8_t(component(1)), std::uint8_t(component(2))};
  }

 private:
  static constexpr int kBits = 40;
  std::array<std::int64_t, 3> value_, step_;
};

}  // namespace lightbench
