#include "reports/run_report.h"

#include <cmath>

namespace lightbench {

MetricValue metric_of(const ReportScore& score, const std::string& metric) {
  if (score.outcome == Outcome::failed)
    return MetricValue::undefined(score.error.empty() ? "it failed" : "it failed: " + score.error);
  if (score.outcome == Outcome::skipped)
    return MetricValue::undefined(score.error.empty() ? "it was skipped" : "it was skipped: " + score.error);
  const auto found = score.metrics.find(metric);
  if (found == score.metrics.end()) return MetricValue::undefined("it was not computed");
  if (found->second.value && !std::isfinite(*found->second.value))
    return MetricValue::undefined("not a finite number");
  return found->second;
}

MeanValue mean_metric(const RunReport& report, const std::string& metric, const std::string& variant,
                      const std::string& reference, const std::string& scene) {
  MeanValue result;
  double sum = 0;
  for (const ReportScore& score : report.scores) {
    if (score.variant != variant || score.reference != reference) continue;
    if (!scene.empty() && score.scene != scene) continue;
    const MetricValue value = metric_of(score, metric);
    if (!value.value) {
      ++result.undefined;
      continue;
    }
    sum += *value.value;
    ++result.count;
  }
  result.mean = result.count == 0 ? MetricValue::undefined("no view has a value")
                                  : MetricValue::of(sum / double(result.count));
  return result;
}

}  // namespace lightbench
