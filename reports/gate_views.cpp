#include "reports/gate_views.h"

#include <algorithm>
#include <limits>

#include "reports/gate_bounds.h"

namespace lightbench {

ReportGateView GateViews::unjudged(const ReportScore& score, const std::string& variant) const {
  return {.scene = score.scene,
          .view = score.view,
          .variant = variant == gate_.variant ? "" : variant,
          .state = GateState::not_judged,
          .detail = "was not measured"};
}

GateViews::Row GateViews::judged(const GateSample& sample, const std::string& variant) const {
  Row row{std::numeric_limits<double>::infinity(), unjudged(*sample.score, variant)};
  row.view.state = GateState::not_met;
  if (!sample.value.value) {
    row.view.detail = "has no " + gate_.metric + ": " + sample.value.undefined_because;
    return row;
  }
  const double value = *sample.value.value;
  row.badness = excess(gate_, value);
  row.view.detail = gate_number(value) + broken_bound_text(gate_, value);
  if (!within(gate_, value)) return row;
  row.view.state = GateState::met;
  if (is_within_noise(gate_, sample)) {
    row.view.state = GateState::within_noise;
    row.view.detail += ", " + within_noise_text(margin(gate_, sample), *sample.noise);
  }
  return row;
}

void GateViews::add(const GateSamples& samples, const std::string& variant) {
  for (const GateSample& sample : samples.made) rows_.push_back(judged(sample, variant));
  for (const ReportScore* score : samples.missing) rows_.push_back({0, unjudged(*score, variant)});
}

std::vector<ReportGateView> GateViews::worst_first() && {
  std::ranges::stable_sort(rows_, std::ranges::greater{}, &Row::badness);
  std::vector<ReportGateView> views;
  for (Row& row : rows_) views.push_back(std::move(row.view));
  return views;
}

}  // namespace lightbench
