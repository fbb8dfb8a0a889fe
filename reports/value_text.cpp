#include "reports/value_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "base/text.h"

namespace lightbench {

/// Times up to a hundred thousand years are told in hours.
constexpr double kLongestTime = 3e12;

Metric metric_or_plain(const std::string& name) {
  for (const Metric& metric : metrics())
    if (metric.name == name) return metric;
  return {.name = name, .doc = "", .unit = "", .better = Better::neither};
}

std::string value_text(const Metric& metric, const MetricValue& value, const std::string& undefined_text) {
  if (!value.value || !std::isfinite(*value.value)) return undefined_text;
  const std::string text = fmt::format("{:.{}f}", *value.value, metric.decimals);
  // A small negative number rounds to "-0.00".
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.starts_with('-') ? text.substr(1) : text;
}

std::string metric_heading(const Metric& metric) {
  return metric.unit == "%" ? metric.name + " %" : metric.name;
}

std::string duration_text(double seconds) {
  if (seconds < 0.9995) return fmt::format("{:.0f} ms", seconds * 1e3);
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  if (!(seconds < kLongestTime)) return fmt::format("{:.3g} s", seconds);
  const long long whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

RunCounts count_outcomes(const RunReport& report) {
  RunCounts counts;
  std::set<std::pair<std::string, std::string>> views;
  const auto add = [&](const auto& rows) {
    for (const auto& row : rows) {
      counts.failed += row.outcome == Outcome::failed;
      counts.skipped += row.outcome == Outcome::skipped;
    }
  };
  add(report.bakes);
  add(report.compressions);
  add(report.images);
  add(report.scores);
  for (const ReportImage& image : report.images) views.emplace(image.scene, image.view);
  for (const ReportScore& score : report.scores) views.emplace(score.scene, score.view);
  for (const ReportGate& gate : report.gates) {
    counts.gates_met += gate.state == GateState::met || gate.state == GateState::within_noise;
    counts.gates_not_met += gate.state == GateState::not_met;
    counts.gates_within_noise += gate.state == GateState::within_noise;
    counts.gates_not_judged += gate.state == GateState::not_judged;
  }
  counts.views = views.size();
  return counts;
}

std::vector<FailedTask> failed_tasks(const RunReport& report) {
  std::vector<FailedTask> failed;
  const auto add = [&](const auto& row, const std::string& where, const std::string& what) {
    if (row.outcome == Outcome::failed) failed.push_back({where, what, row.error});
  };
  for (const ReportObject& object : report.bakes) add(object, object.scene, object_task("bake", object));
  for (const ReportObject& object : report.compressions)
    add(object, object.scene, object_task("compression", object));
  for (const ReportImage& image : report.images) add(image, image.scene + "/" + image.view, image.source);
  for (const ReportScore& score : report.scores)
    add(score, score.scene + "/" + score.view, score.variant + " against " + score.reference);
  return failed;
}

std::string variants_text(const ReportObject& object) {
  return join(object.variants, "; ");  // names like "piecewise, 6" have commas
}

std::string object_task(const std::string& task, const ReportObject& object) {
  return fmt::format("{} of {} ({})", task, object.object, variants_text(object));
}

std::string gate_state_text(GateState state) {
  return kGateStateNames[static_cast<std::size_t>(state)];
}

namespace {

std::string gates_text(const RunCounts& counts) {
  const std::size_t gates = counts.gates_met + counts.gates_not_met + counts.gates_not_judged;
  const std::string of_all = " of " + counted(gates, "gate");
  if (counts.gates_not_met > 0) {
    const std::string rest =
        counts.gates_not_judged > 0 ? fmt::format(", {} not judged", counts.gates_not_judged) : "";
    return std::to_string(counts.gates_not_met) + of_all + " not met" + rest;
  }
  if (counts.gates_not_judged > 0) return std::to_string(counts.gates_not_judged) + of_all + " not judged";
  if (gates == 0) return "";
  const std::string met = gates == 1 ? "The gate is met" : fmt::format("All {} gates met", gates);
  return counts.gates_within_noise == 0
             ? met
             : fmt::format("{}, {} within the reference's noise", met, counts.gates_within_noise);
}

}  // namespace

std::string verdict_text(const RunCounts& counts) {
  std::string text = gates_text(counts);
  const auto append = [&](std::size_t count, const char* what) {
    if (count == 0) return;
    text += (text.empty() ? "" : ", ") + counted(count, "task") + " " + what;
  };
  append(counts.failed, "failed");
  append(counts.skipped, "skipped");
  return text.empty() ? "Finished" : text;
}

std::vector<const ReportScore*> worst_first(const RunReport& report, const std::string& metric,
                                            const std::string& variant, const std::string& reference) {
  std::vector<std::pair<double, const ReportScore*>> order;
  const bool higher_is_better = metric_or_plain(metric).better == Better::higher;
  for (const ReportScore& score : report.scores) {
    if (score.variant != variant || score.reference != reference) continue;
    const MetricValue value = metric_of(score, metric);
    const double badness = value.value ? (higher_is_better ? -*value.value : *value.value)
                                       : std::numeric_limits<double>::infinity();
    order.emplace_back(badness, &score);
  }
  std::ranges::stable_sort(order, std::ranges::greater{}, [](const auto& entry) { return entry.first; });
  std::vector<const ReportScore*> scores;
  scores.reserve(order.size());
  for (const auto& [badness, score] : order) scores.push_back(score);
  return scores;
}

std::string measured_text(const std::vector<const ReportScore*>& scores) {
  const auto made = std::ranges::count(scores, Outcome::ok, &ReportScore::outcome);
  return std::size_t(made) == scores.size() ? std::to_string(made)
                                            : fmt::format("{} of {}", made, scores.size());
}

std::string leading_metric(const RunReport& report) {
  if (report.metric_names.empty()) return "";
  const bool has_gain = std::ranges::find(report.metric_names, "gain") != report.metric_names.end();
  return has_gain ? "gain" : report.metric_names.front();
}

}  // namespace lightbench
