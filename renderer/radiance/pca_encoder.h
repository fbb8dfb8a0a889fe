#pragma once

#include <cstdint>
#include <span>

#include "renderer/radiance/pca.h"

namespace lightbench {

/// Errors are in steps of 8 bits; that of a value, a texel in one direction, is the mean of |decoded - true|
/// over its three components.
struct PcaOptions {
  /// Even, 4 to 64. An object gets as few as its error allows, at least 4.
  int max_coefficients = 40;
  /// Of each of the first four coefficients, 8 or 16. With 16 they show no steps where what they paint is
  /// smooth, for 4 more bytes a texel.
  int first_bits = 8;
  double mean_error = 1.1;  ///< the largest mean over those values that are not decoded as they were
  double error_99 = 6;      ///< the largest error that 99 % of all values may not exceed
  /// Not 0: corrections instead of those two. As few bytes as can be with which the sum of |decoded - true|
  /// over the components is below this in every value.
  int threshold = 0;
};

/// `counts` tells of each place of a layer whether a texel is there (not 0); empty: all are. What other
/// places decode to is left open. Where max_coefficients are too few for the errors that are wanted, they
/// are larger. A matte object is lossless.
PcaStack encode_pca(const HalfStack& stack, std::span<const std::uint8_t> counts, const PcaOptions& options);

}  // namespace lightbench
