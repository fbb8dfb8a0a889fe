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
  bool front = false;  ///< no other variant gains as much in less time
};

/// The variants of which both are known, against the primary reference, the cheapest first. Times of ordinary
/// runs are contended, but those of processors suffer little from it.
std::vector<CostPoint> cost_points(const RunReport& report);

/// They as an SVG picture, gain over time on a logarithmic scale, those of the front by name and the others
/// with a tooltip; empty with fewer than three.
std::string cost_chart(const RunReport& report);

/// The mean processor time over the pictures of a variant for which it is known; 0 where it is for none.
double mean_cpu_seconds(const RunReport& report, const std::string& variant);

}  // namespace lightbench
