#include "reports/ceiling.h"

#include <algorithm>

#include "reports/value_text.h"

namespace lightbench {

namespace {

/// Whether the variant is traced like the reference and from the same seed, so that it has the same noise.
bool repeats(const ReportImageSource& variant, const ReportImageSource& reference) {
  const auto seed = variant.params.find("seed"), other = reference.params.find("seed");
  return variant.kind == reference.kind && seed != variant.params.end() && other != reference.params.end() &&
         seed->second == other->second;
}

}  // namespace

const ReportImageSource* ceiling_variant(const RunReport& report, const std::string& reference) {
  const auto of_name = std::ranges::find(report.references, reference, &ReportImageSource::name);
  if (of_name == report.references.end()) return nullptr;
  const auto found = std::ranges::find_if(report.variants, [&](const ReportImageSource& variant) {
    return variant.offline && !variant.limited && variant.bounces == of_name->bounces &&
           !repeats(variant, *of_name);
  });
  return found == report.variants.end() ? nullptr : &*found;
}

MetricValue ceiling_of(const RunReport& report, const ReportScore& score) {
  const ReportImageSource* variant = ceiling_variant(report, score.reference);
  if (!variant)
    return MetricValue::undefined("no path-traced variant has the reference's bounces and another seed");
  const auto found = std::ranges::find_if(report.scores, [&](const ReportScore& other) {
    return other.variant == variant->name && other.reference == score.reference &&
           other.scene == score.scene && other.view == score.view;
  });
  if (found == report.scores.end()) return MetricValue::undefined("the path-traced variant has no score");
  return metric_of(*found, "gain");
}

MetricValue mean_ceiling(const RunReport& report, const std::string& reference, const std::string& scene) {
  const ReportImageSource* variant = ceiling_variant(report, reference);
  if (!variant)
    return MetricValue::undefined("no path-traced variant has the reference's bounces and another seed");
  return mean_metric(report, "gain", variant->name, reference, scene).mean;
}

std::string gain_text(const MetricValue& gain, const MetricValue& ceiling) {
  const Metric metric = metric_or_plain("gain");
  const std::string text = value_text(metric, gain);
  return gain.value && ceiling.value && gain != ceiling ? text + " / " + value_text(metric, ceiling) : text;
}

}  // namespace lightbench
