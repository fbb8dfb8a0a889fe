#pragma once

#include "renderer/paths/lanes.h"

namespace lightbench {

/// x^y for 0 < x <= 1 and y >= 0. The relative error is below 1e-6 + 3e-7 y; below 2^-126 the result is 0.
/// Logarithm and exponential are polynomials over half an octave on each side.
[[gnu::always_inline]] inline Float8 power8(Float8 x, Float8 y) {
  // x = 2^e m with m in [sqrt(1/2), sqrt(2)); log2 m by the series of atanh((m - 1) / (m + 1)).
  const Int8 bits = Int8(x);
  const Int8 shifted = bits - 0x3f3504f3;  // of sqrt(1/2)
  const Int8 e = shifted >> 23;
  const Float8 m = Float8((shifted & 0x7fffff) + 0x3f3504f3);
  const Float8 r = (m - 1) / (m + 1), rr = r * r;
  const Float8 series =
      r * (2.8853900818f + rr * (0.9617966939f + rr * (0.5770780164f + rr * (0.4121985831f + rr * 0.32f))));
  const Float8 exponent = y * (__builtin_convertvector(e, Float8) + series);
  const Int8 vanishes = exponent < -126;
  const Float8 p = select(vanishes, splat(0), exponent);
  // 2^p = 2^whole 2^part, part in [-1/2, 1/2].
  const Int8 whole = __builtin_convertvector(p - 0.5f, Int8);  // towards 0, and p <= 0: rounds to the nearest
  const Float8 part = p - __builtin_convertvector(whole, Float8);
  const Float8 t = part * 0.6931471806f;
  const Float8 rest =
      1 + t * (1 + t * (0.5f + t * (1.0f / 6 + t * (1.0f / 24 + t * (1.0f / 120 + t * (1.0f / 720))))));
  const Float8 result = Float8(Int8(rest) + (whole << 23));
  return select(vanishes, splat(0), result);
}

}  // namespace lightbench
