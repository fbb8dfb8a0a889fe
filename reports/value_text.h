#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/metric.h"
#include "reports/run_report.h"

/// How numbers look in every report.
namespace lightbench {

/// The metric's row, or one with its name alone where this lightbench does not know it (a run of another
/// version).
Metric metric_or_plain(const std::string& name);

/// With the metric's decimals; `undefined_text` where there is no number.
std::string value_text(const Metric& metric, const MetricValue& value,
                       const std::string& undefined_text = "-");

/// "gain %", "mean_error".
std::string metric_heading(const Metric& metric);

/// "85 ms", "4.2 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

/// "1 view", "3 views".
std::string counted(std::size_t count, const std::string& noun);

/// What a run came to.
struct RunCounts {
  std::size_t views = 0;
  std::size_t failed = 0;  ///< images, scores, bakes and compressions
  std::size_t skipped = 0;
  std::size_t gates_met = 0;  ///< those within the noise too
  std::size_t gates_not_met = 0;
  std::size_t gates_within_noise = 0;
  std::size_t gates_not_judged = 0;
};
RunCounts count_outcomes(const RunReport& report);

/// A task that failed: on which view or scene, what it was to make, and why it did not.
struct FailedTask {
  std::string where;
  std::string what;
  std::string error;
};
/// Those before others first.
std::vector<FailedTask> failed_tasks(const RunReport& report);

/// The variants that draw an object: "raw; piecewise".
std::string variants_text(const ReportObject& object);

/// "bake of floor (raw; piecewise)".
std::string object_task(const std::string& task, const ReportObject& object);

/// "met", "not met", "within noise", "not judged".
std::string gate_state_text(GateState state);

/// "All 5 gates met", "1 of 5 gates not met, 2 tasks failed": the run in one line.
std::string verdict_text(const RunCounts& counts);

/// The scores of (variant, reference), from bad to good by `metric`; those without a number come first.
std::vector<const ReportScore*> worst_first(const RunReport& report, const std::string& metric,
                                            const std::string& variant, const std::string& reference);

/// How many of these scores were made: "12", or "10 of 12" where some failed or were not asked for.
std::string measured_text(const std::vector<const ReportScore*>& scores);

/// "gain" where the run has it, else its first metric; empty where it has none.
std::string leading_metric(const RunReport& report);

}  // namespace lightbench
