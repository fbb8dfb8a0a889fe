#pragma once

#include <string>
#include <vector>

#include "reports/run_report.h"

namespace lightbench {

/// A variant's mean processor time of a picture and its mean gain.
struct CostPoint {
  std::string variant;
  double seconds = 0;
  double gain = 0;     ///< percent
  bool front = false;  ///< no other variant gains as much in less time; false where times are contended
};

/// Whether a time that `cost_points` uses was met while other tasks ran, so that it cannot tell variants
/// apart.
bool has_contended_costs(const RunReport& report);

/// Returns the variants of which time and gain are known, against the primary reference, the cheapest first.
std::vector<CostPoint> cost_points(const RunReport& report);

/// Draws the cost points as an SVG picture, gain over time on a logarithmic scale. Variants of the front have
/// their names beside them and the others in a tooltip; where no front is known, all have their names if
/// there are few. The text is empty with fewer than three points.
std::string cost_chart(const RunReport& report);

/// The mean processor time over the pictures of a variant for which it is known; 0 where it is for none.
double mean_cpu_seconds(const RunReport& report, const std::string& variant);

}  // namespace lightbench
