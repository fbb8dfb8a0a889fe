#pragma once

#include <string>
#include <vector>

#include "reports/gate_samples.h"
#include "reports/verdict.h"

namespace lightbench {

/// How a gate that holds for each view came out on them, with the worst first.
class GateViews {
 public:
  explicit GateViews(const Gate& gate) : gate_(gate) {}

  /// Judges the scores of a variant, which is named with each view where the gate has a pattern instead.
  void add(const GateSamples& samples, const std::string& variant);
  std::vector<ReportGateView> worst_first() &&;

 private:
  struct Row {
    double badness;
    ReportGateView view;
  };
  Row judged(const GateSample& sample, const std::string& variant) const;
  ReportGateView unjudged(const ReportScore& score, const std::string& variant) const;

  const Gate& gate_;
  std::vector<Row> rows_;
};

}  // namespace lightbench
