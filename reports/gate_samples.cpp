#include "reports/gate_samples.h"

#include <algorithm>

#include "base/text.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

/// What is called by its name is meant alone, though its name may be a pattern, such as isr[samples=24].
bool matches(const std::string& name, const std::string& pattern, const std::set<std::string>& names) {
  return pattern.empty() || (names.contains(pattern) ? name == pattern : matches_glob(name, pattern));
}

}  // namespace

GateSampler::GateSampler(const RunReport& report) : report_(report) {
  for (const ReportImage& image : report.images) images_[{{image.scene, image.view}, image.source}] = &image;
  for (const ReportScore& score : report.scores) {
    scenes_.insert(score.scene);
    views_.insert(score.view);
    if (score.variant == report.baseline)
      baseline_error_[{{score.scene, score.view}, score.reference}] = metric_of(score, "mean_error").value;
  }
}

const ReportImage* GateSampler::image(const ReportScore& score, const std::string& source) const {
  const auto found = images_.find({{score.scene, score.view}, source});
  return found == images_.end() ? nullptr : found->second;
}

/// A score that was skipped because a picture that it needs has failed was tried all the same.
bool GateSampler::was_tried(const ReportScore& score) const {
  if (score.outcome != Outcome::skipped) return true;
  const auto failed = [&](const std::string& source) {
    const ReportImage* needed = image(score, source);
    return needed && needed->outcome == Outcome::failed;
  };
  return failed(score.variant) || failed(score.reference) || failed(report_.baseline);
}

std::optional<double> GateSampler::unit_of(const ReportScore& score, NoiseUnit unit) const {
  if (unit == NoiseUnit::none) return std::nullopt;
  if (unit == NoiseUnit::error) return 1;
  const auto error = baseline_error_.find({{score.scene, score.view}, score.reference});
  if (error == baseline_error_.end() || !error->second) return std::nullopt;
  return *error->second / 100;
}

GateSamples GateSampler::samples_of(const Gate& gate, const std::string& variant) const {
  const std::string& reference = gate.reference.empty() ? report_.primary_reference : gate.reference;
  const NoiseUnit unit = metric_or_plain(gate.metric).noise_unit;
  GateSamples samples;
  for (const ReportScore& score : report_.scores) {
    if (score.variant != variant || (!reference.empty() && score.reference != reference) ||
        !matches(score.scene, gate.scene, scenes_) || !matches(score.view, gate.view, views_))
      continue;
    if (!was_tried(score)) {
      samples.missing.push_back(&score);
      continue;
    }
    const ReportImage* truth = image(score, score.reference);
    samples.made.push_back(
        {&score, metric_of(score, gate.metric), truth ? truth->noise : std::nullopt, unit_of(score, unit)});
  }
  return samples;
}

}  // namespace lightbench
