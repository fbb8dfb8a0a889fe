#pragma once

#include "renderer/radiance/piecewise.h"

namespace lightbench {

/// Which layers of a texel are kept. An error is that of one value: the sum over its three components of
/// |decoded - true|.
enum class SampleRule {
  /// From each kept sample to the farthest layer that a line can reach with every error below the threshold.
  greedy,
  /// The thesis's (7.2.4), mended: a layer is kept where the step from it to the next, compared with the
  /// first step after the last kept sample, differs by the threshold or more in the sum over the components,
  /// differs by half of the threshold or more in one, or goes the other way in one; a step
  /// of 0 goes either way. Nothing bounds the error but at thresholds 0 and 1.
  ///
  /// The pseudo code there keeps the layer behind the bend, so that the line to it misses the bend and
  /// threshold 0 is not lossless, which the thesis says that it is. It compares differences with their signs,
  /// where the text beside it means rising and falling slopes alike, and it ends without the last layer.
  paper
};

/// Thresholds 0 and 1 are lossless. Throws Error where there are 2^32 values or more.
PiecewiseStack encode_piecewise(const ByteStack& stack, SampleRule rule, int threshold);

}  // namespace lightbench
