#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "reports/run_report.h"
#include "reports/verdict.h"

namespace lightbench {

/// One score that a gate looks at.
struct GateSample {
  const ReportScore* score;
  MetricValue value;
  std::optional<double> noise;  ///< of its reference image, of 255
  std::optional<double> unit;   ///< by how much of 255 the error changes where the metric changes by 1
};

/// The scores of one variant that a gate is about.
struct GateSamples {
  std::vector<GateSample> made;             ///< those that were made, or that failed
  std::vector<const ReportScore*> missing;  ///< those that this run neither made nor tried to make
};

/// Finds what gates look at. Made once for all gates of a run, which must outlive it.
class GateSampler {
 public:
  explicit GateSampler(const RunReport& report);

  GateSamples samples_of(const Gate& gate, const std::string& variant) const;

 private:
  using View = std::pair<std::string, std::string>;  ///< scene and view

  const ReportImage* image(const ReportScore& score, const std::string& source) const;
  bool was_tried(const ReportScore& score) const;
  std::optional<double> unit_of(const ReportScore& score, NoiseUnit unit) const;

  const RunReport& report_;
  std::set<std::string> scenes_;
  std::set<std::string> views_;
  std::map<std::pair<View, std::string>, const ReportImage*> images_;             ///< by view and source
  std::map<std::pair<View, std::string>, std::optional<double>> baseline_error_;  ///< by view and reference
};

}  // namespace lightbench
