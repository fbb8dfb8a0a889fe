#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/run_report.h"

/// Metrics return numbers; gates say which numbers are good enough.
namespace lightbench {

/// A rule on scores. Both bounds are inclusive; at least one is there.
struct Gate {
  enum class Over {
    each,   ///< every view for itself
    mean,   ///< the mean over the views
    worst,  ///< the view farthest on the wrong side of a bound
  };

  std::string metric;
  std::string variant;    ///< a name, or a pattern with * ? [..]: then each matching variant must pass
  std::string reference;  ///< a name; empty: the primary reference
  std::string scene;      ///< a pattern; empty: all
  std::string view;       ///< a pattern; empty: all
  std::optional<double> min;
  std::optional<double> max;
  Over over = Over::each;
  std::string as_written;  ///< shown in reports; empty: `describe`
  std::string where{};     ///< its place in the job, for errors
};

/// "mean gain of isr >= 25 against povray, scene office".
std::string describe(const Gate& gate);

/// "gain of isr against povray, scene office, mean, min": the same while only the numbers of the bounds
/// change.
std::string gate_name(const Gate& gate);

/// A gate is met only where it has scores to look at and each of them has a number within the bounds (or
/// their mean has): a failed task, an undefined value or no matching score at all is a gate not met, and
/// `detail` says which and why, the worst view first. A gate is not judged where the run made none of its
/// scores, or only some of them, unless one of these breaks the bounds by itself; in a partial run the scores
/// that are there decide. Where the metric is an error or a gain and the reference's noise is known, a gate
/// that is met by less than that noise is `within_noise`: the reference is not exact enough to tell.
ReportGate evaluate_gate(const Gate& gate, const RunReport& report);

/// All of them; where several would have one name, the second and so on have their number behind it.
std::vector<ReportGate> evaluate_gates(std::span<const Gate> gates, const RunReport& report);

}  // namespace lightbench
