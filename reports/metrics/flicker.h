#pragma once

#include "reports/metric.h"

namespace lightbench {

/// How much the error changes from the frame before: the mean of |(S - R) - (S' - R')| over the pixels that
/// objects cover in both references and their components, S and S' being the image of this frame and of the
/// one before, R and R' their references. 0 to 510; 0 where the error stays as it is, however large.
/// Undefined where no pixel is of an object in both frames.
MetricValue flicker(const MetricInput& input);

}  // namespace lightbench
