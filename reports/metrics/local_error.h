#pragma once

#include "reports/metric.h"

/// Metrics for what is broken in a part of the picture and vanishes in its mean. The error of a pixel is that
/// of pixel_error.h, in 8-bit sRGB.
namespace lightbench {

/// The largest |a - b| over all pixels and components; 0..255. One broken pixel is enough.
MetricValue max_error(const MetricInput& input);

/// The 99th percentile of the pixels' errors by nearest rank: the smallest error that at least 99 % of the
/// pixels do not exceed; 0..255. What covers less than 1 % of the picture does not show in it.
MetricValue p99_error(const MetricInput& input);

/// An error of more than this, of 255, makes a bad pixel. Eight steps of sRGB in the middle of the scale are
/// 3.2 in CIE L*, just above the 2.3 that people tell apart side by side (Mahy et al. 1994); the last bits in
/// which rasters and rounding differ (1 or 2) stay well below.
inline constexpr int kBadPixelError = 8;

/// The share of bad pixels, in percent.
MetricValue bad_pixels(const MetricInput& input);

}  // namespace lightbench
