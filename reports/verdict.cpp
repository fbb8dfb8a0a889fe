#include "reports/verdict.h"

#include <algorithm>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "base/text.h"
#include "reports/gate_bounds.h"
#include "reports/gate_samples.h"
#include "reports/gate_views.h"

namespace lightbench {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Judgement {
  bool passed = false;
  double excess = kInfinity;  ///< of the worst view, or of their mean
  std::string detail{};
  std::string noise{};  ///< why it is met by too little to be sure
};

/// What is said of one view or variant, and how bad it is.
struct Remark {
  double badness;
  std::string text;
};

std::string place(const ReportScore& score) {
  return score.scene + "/" + score.view;
}

/// "a; b; c; and 4 more": a detail stays one readable line.
std::string some_of(const std::vector<std::string>& items) {
  constexpr std::size_t kShown = 5;
  const std::vector<std::string> shown(items.begin(),
                                       items.begin() + std::ptrdiff_t(std::min(kShown, items.size())));
  std::string text = join(shown, "; ");
  if (items.size() > kShown) text += fmt::format("; and {} more", items.size() - kShown);
  return text;
}

/// The same with the worst first.
std::string some_of(std::vector<Remark> remarks) {
  std::ranges::stable_sort(remarks, std::ranges::greater{}, &Remark::badness);
  std::vector<std::string> texts;
  for (Remark& remark : remarks) texts.push_back(std::move(remark.text));
  return some_of(texts);
}

std::string views(std::size_t count) {
  return count == 1 ? "1 view" : fmt::format("{} views", count);
}

Judgement judge_mean(const Gate& gate, const std::vector<GateSample>& samples) {
  double sum = 0;
  for (const GateSample& sample : samples) sum += *sample.value.value;
  const double mean = sum / double(samples.size());
  return {within(gate, mean), excess(gate, mean),
          fmt::format("{} mean of {}{}", gate_number(mean), views(samples.size()),
                      broken_bound_text(gate, mean))};
}

Judgement judge_worst(const Gate& gate, const std::vector<GateSample>& samples) {
  const GateSample& worst = *std::ranges::max_element(
      samples, {}, [&](const GateSample& sample) { return excess(gate, *sample.value.value); });
  const double value = *worst.value.value;
  return {within(gate, value), excess(gate, value),
          fmt::format("{} on {}, the worst of {}{}", gate_number(value), place(*worst.score),
                      views(samples.size()), broken_bound_text(gate, value))};
}

Judgement judge_each(const Gate& gate, const std::vector<GateSample>& samples) {
  const Judgement worst = judge_worst(gate, samples);
  std::vector<Remark> broken;
  for (const GateSample& sample : samples)
    if (const double value = *sample.value.value; !within(gate, value))
      broken.push_back(
          {excess(gate, value), fmt::format("{} on {}{}", gate_number(value), place(*sample.score),
                                            broken_bound_text(gate, value))});
  if (broken.empty()) return {true, worst.excess, "all met; " + worst.detail};
  const std::size_t count = broken.size();
  return {false, worst.excess,
          fmt::format("{} of {}: {}", count, views(samples.size()), some_of(std::move(broken)))};
}

/// Which difference is smaller than the noise, or nothing. Samples of which neither is known do not count.
std::string within_noise(const Gate& gate, std::vector<GateSample> samples) {
  std::erase_if(samples, [](const GateSample& sample) { return !sample.noise || !sample.unit; });
  if (samples.empty()) return "";
  if (gate.over == Gate::Over::mean) {
    double margins = 0, noise = 0;
    for (const GateSample& sample : samples) {
      margins += margin(gate, sample);
      noise += *sample.noise;
    }
    const double count = double(samples.size());
    return margins < noise ? within_noise_text(margins / count, noise / count) : "";
  }
  std::vector<Remark> found;
  for (const GateSample& sample : samples)
    if (is_within_noise(gate, sample))
      found.push_back({-margin(gate, sample),
                       place(*sample.score) + " " + within_noise_text(margin(gate, sample), *sample.noise)});
  return some_of(std::move(found));
}

Judgement judge_values(const Gate& gate, const std::vector<GateSample>& samples) {
  switch (gate.over) {
    case Gate::Over::each:
      return judge_each(gate, samples);
    case Gate::Over::mean:
      return judge_mean(gate, samples);
    case Gate::Over::worst:
      return judge_worst(gate, samples);
  }
  return {.detail = "unknown kind of gate"};
}

Judgement judge(const Gate& gate, const std::vector<GateSample>& samples) {
  std::vector<std::string> without_number;
  for (const GateSample& sample : samples)
    if (!sample.value.value)
      without_number.push_back(
          fmt::format("{} has no {}: {}", place(*sample.score), gate.metric, sample.value.undefined_because));
  if (!without_number.empty()) return {.detail = some_of(without_number)};
  Judgement judgement = judge_values(gate, samples);
  if (judgement.passed) judgement.noise = within_noise(gate, samples);
  return judgement;
}

bool has_numbers(const std::vector<GateSample>& samples) {
  return std::ranges::all_of(samples,
                             [](const GateSample& sample) { return sample.value.value.has_value(); });
}

/// How a gate came out for each variant that it is about.
struct Findings {
  std::vector<Remark> met, not_met;
  std::vector<std::string> not_judged, uncertain;

  void add(const Gate& gate, const GateSamples& samples, bool partial, const std::string& who);
  ReportGate summed_up(ReportGate gate) const;
};

/// The scores that are missing can change a mean, but neither a view that breaks its bound nor one without a
/// number.
void Findings::add(const Gate& gate, const GateSamples& samples, bool partial, const std::string& who) {
  const std::size_t all = samples.made.size() + samples.missing.size();
  if (samples.made.empty())
    return not_judged.push_back(fmt::format("{}none of {} was measured", who, views(all)));
  const Judgement judgement = judge(gate, samples.made);
  const bool whole = samples.missing.empty() || partial;
  const bool may_change = judgement.passed || (gate.over == Gate::Over::mean && has_numbers(samples.made));
  if (!whole && may_change)
    return not_judged.push_back(fmt::format("{}measured on {} of {} only: {}", who, samples.made.size(),
                                            views(all), judgement.detail));
  (judgement.passed ? met : not_met).push_back({judgement.excess, who + judgement.detail});
  if (!judgement.noise.empty()) uncertain.push_back(who + judgement.noise);
}

ReportGate Findings::summed_up(ReportGate gate) const {
  if (!not_met.empty()) {
    gate.detail = some_of(not_met);
  } else if (!not_judged.empty()) {
    gate.state = GateState::not_judged;
    gate.detail = some_of(not_judged);
  } else if (met.empty()) {
    gate.detail = "no score matches";
  } else {
    gate.state = uncertain.empty() ? GateState::met : GateState::within_noise;
    gate.detail = some_of(met);
    if (!uncertain.empty()) gate.detail += "; " + some_of(uncertain);
  }
  return gate;
}

ReportGate evaluate(const Gate& gate, const RunReport& report, const GateSampler& sampler) {
  ReportGate result;
  result.text = gate.as_written.empty() ? describe(gate) : gate.as_written;
  result.name = gate_name(gate);
  if (!gate.min && !gate.max) {
    result.detail = "the gate has neither a lower nor an upper bound";
    return result;
  }
  Findings findings;
  GateViews views(gate);
  const bool is_named = std::ranges::count(report.variants, gate.variant, &ReportImageSource::name) > 0;
  for (const ReportImageSource& variant : report.variants) {
    if (is_named ? variant.name != gate.variant : !matches_glob(variant.name, gate.variant)) continue;
    const GateSamples samples = sampler.samples_of(gate, variant.name);
    if (samples.made.empty() && samples.missing.empty()) continue;
    findings.add(gate, samples, report.partial, variant.name == gate.variant ? "" : variant.name + ": ");
    if (gate.over == Gate::Over::each) views.add(samples, variant.name);
  }
  result.views = std::move(views).worst_first();
  return findings.summed_up(std::move(result));
}

/// What a gate is about besides its metric and variant.
std::string scope_text(const Gate& gate) {
  std::string text;
  if (!gate.reference.empty()) text += " against " + gate.reference;
  if (!gate.scene.empty()) text += ", scene " + gate.scene;
  if (!gate.view.empty()) text += ", view " + gate.view;
  return text;
}

}  // namespace

std::string describe(const Gate& gate) {
  static constexpr const char* kOver[] = {"each", "mean", "worst"};
  return fmt::format("{} {} of {} {}{}", kOver[static_cast<std::size_t>(gate.over)], gate.metric,
                     gate.variant, bounds_text(gate), scope_text(gate));
}

std::string gate_name(const Gate& gate) {
  static constexpr const char* kOver[] = {"each view", "mean", "worst view"};
  return fmt::format("{} of {}{}, {}{}{}", gate.metric, gate.variant, scope_text(gate),
                     kOver[static_cast<std::size_t>(gate.over)], gate.min ? ", min" : "",
                     gate.max ? ", max" : "");
}

ReportGate evaluate_gate(const Gate& gate, const RunReport& report) {
  return evaluate(gate, report, GateSampler(report));
}

std::vector<ReportGate> evaluate_gates(std::span<const Gate> gates, const RunReport& report) {
  const GateSampler sampler(report);
  std::vector<ReportGate> results;
  std::map<std::string, int> named;
  for (const Gate& gate : gates) {
    ReportGate& result = results.emplace_back(evaluate(gate, report, sampler));
    if (const int before = named[result.name]++; before > 0)
      result.name += fmt::format(" ({})", before + 1);  // as where one bound warns and a wider one fails
  }
  return results;
}

}  // namespace lightbench
