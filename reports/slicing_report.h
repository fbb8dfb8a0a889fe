#pragma once

#include <string>
#include <vector>

#include "reports/report_formats.h"

namespace lightbench {

/// What one way of drawing took: milliseconds, median and quartiles over the rounds.
struct MethodTime {
  std::string method;
  double median = 0, lower = 0, upper = 0;
};

/// One receiver cut by one number of planes.
struct SlicingTimes {
  int planes = 0;
  int used = 0;  ///< of them, those that the receiver lies on
  std::vector<MethodTime> methods;
  std::size_t differing =
      0;  ///< the most texels in which a method's light differs from the first's that should not
};

/// One receiver in the light of one lamp.
struct SlicedReceiver {
  std::string scene, receiver, light;
  std::vector<SlicingTimes> times;           ///< by growing number of planes
  std::vector<std::size_t> texels_by_plane;  ///< of the map, for the most planes
};

struct SlicingReport {
  std::string renderer;  ///< of OpenGL
  int rounds = 0;
  int layers = 2;  ///< of the position map
  std::vector<SlicedReceiver> receivers;
};

/// A fraction of the medians of two methods, as tables show it.
struct MethodRatio {
  const char* name;
  const char* over;
  const char* under;
};
const std::vector<MethodRatio>& slicing_ratios();

/// slicing.md with all numbers, and index.html with them and, of each receiver that was cut by at least three
/// numbers of planes, charts of the times and of the depths.
std::vector<ReportFile> slicing_files(const SlicingReport& report);

}  // namespace lightbench
