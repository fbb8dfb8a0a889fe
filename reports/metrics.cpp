#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "reports/metric.h"
#include "reports/metrics/block_error.h"
#include "reports/metrics/closeness.h"
#include "reports/metrics/flicker.h"
#include "reports/metrics/gain.h"
#include "reports/metrics/local_error.h"
#include "reports/metrics/luminance_error.h"
#include "reports/metrics/luv.h"
#include "reports/metrics/mean_error.h"
#include "reports/metrics/over_ambient.h"
#include "reports/metrics/pearson.h"
#include "reports/metrics/quality.h"
#include "reports/metrics/rmse.h"

namespace lightbench {

std::span<const Metric> metrics() {
  static const Metric table[] = {
      {.name = "mean_error",
       .doc = "mean absolute difference over all pixels and components",
       .unit = "of 255",
       .better = Better::lower,
       .noise_unit = NoiseUnit::error,
       .decimals = 3,
       .compute = mean_error},
      {.name = "pearson",
       .doc = "Pearson correlation over all components pooled, -1 to 1",
       .unit = "",
       .better = Better::higher,
       .decimals = 4,
       .compute = pearson},
      {.name = "luv",
       .doc = "mean distance in CIE 1976 L*u*v* (D65) over the object pixels, at most 274.6",
       .unit = "",
       .better = Better::lower,
       .masked = true,
       .decimals = 3,
       .compute = luv},
      {.name = "luminance_error",
       .doc = "mean absolute difference of 0.27 R + 0.67 G + 0.06 B",
       .unit = "of 255",
       .better = Better::lower,
       .noise_unit = NoiseUnit::error,
       .decimals = 3,
       .compute = luminance_error},
      {.name = "rmse",
       .doc = "square root of the mean squared difference over all pixels and components",
       .unit = "of 255",
       .better = Better::lower,
       .noise_unit = NoiseUnit::error,
       .decimals = 3,
       .compute = rmse},
      {.name = "gain",
       .doc = "by how much the mean error is below the baseline's, in percent of the baseline's",
       .unit = "%",
       .better = Better::higher,
       .needs_baseline = true,
       .noise_unit = NoiseUnit::percent_of_baseline,
       .decimals = 2,
       .compute = gain},
      {.name = "quality",
       .doc =
           "-1 where the image has a smaller mean error than the baseline, 1 where the baseline has, 0 where "
           "both have the same",
       .unit = "",
       .better = Better::lower,
       .needs_baseline = true,
       .decimals = 0,
       .compute = quality},
      {.name = "closer",
       .doc = "share of pixels, in percent, strictly closer to the reference than the baseline's",
       .unit = "%",
       .better = Better::higher,
       .needs_baseline = true,
       .decimals = 1,
       .compute = closer_share},
      {.name = "farther",
       .doc = "share of pixels, in percent, strictly farther from the reference than the baseline's",
       .unit = "%",
       .better = Better::lower,
       .needs_baseline = true,
       .decimals = 1,
       .compute = farther_share},
      {.name = "equal",
       .doc = "share of pixels, in percent, as far from the reference as the baseline's",
       .unit = "%",
       .better = Better::neither,
       .needs_baseline = true,
       .decimals = 1,
       .compute = equal_share},
      {.name = "ambient_fit",
       .doc = "gain of the baseline with the best constant ambient light, fitted to the reference in each "
              "view: what a "
              "technique has to beat",
       .unit = "%",
       .better = Better::neither,
       .needs_baseline = true,
       .needs_ambient_fit = true,
       .decimals = 2,
       .compute = ambient_fit_gain},
      {.name = "over_ambient",
       .doc =
           "by how much the mean error is below that of the best constant ambient light, in percent of that",
       .unit = "%",
       .better = Better::higher,
       .needs_baseline = true,
       .needs_ambient_fit = true,
       .decimals = 2,
       .compute = over_ambient},
      {.name = "flicker",
       .doc = "mean absolute change of the signed error from the frame before, over the pixels that objects "
              "cover in both",
       .unit = "of 255",
       .better = Better::lower,
       .needs_previous = true,
       .masked = true,
       .decimals = 3,
       .compute = flicker},
      {.name = "max_error",
       .doc = "largest absolute difference over all pixels and components: one broken pixel is enough",
       .unit = "of 255",
       .better = Better::lower,
       .on_request = true,
       .decimals = 0,
       .compute = max_error},
      {.name = "p99_error",
       .doc = "error that 99 % of the pixels do not exceed; a pixel's is its largest component's",
       .unit = "of 255",
       .better = Better::lower,
       .on_request = true,
       .decimals = 0,
       .compute = p99_error},
      {.name = "bad_pixels",
       .doc = "share of pixels, in percent, with a component that is off by more than 8 of 255",
       .unit = "%",
       .better = Better::lower,
       .on_request = true,
       .decimals = 4,
       .compute = bad_pixels},
      {.name = "block_error",
       .doc =
           "largest mean error of any block of 16 x 16 pixels: finds a broken patch among single pixels that "
           "are off",
       .unit = "of 255",
       .better = Better::lower,
       .on_request = true,
       .decimals = 3,
       .compute = block_error},
  };
  return table;
}

std::vector<std::string> default_metrics() {
  std::vector<std::string> names;
  for (const Metric& metric : metrics())
    if (!metric.on_request && !metric.needs_ambient_fit && !metric.needs_previous)
      names.push_back(metric.name);
  return names;
}

std::vector<std::string> sequence_metrics() {
  std::vector<std::string> names;
  for (const Metric& metric : metrics())
    if (metric.needs_previous) names.push_back(metric.name);
  return names;
}

bool needs_ambient_fit(const std::vector<std::string>& metrics) {
  return std::any_of(metrics.begin(), metrics.end(),
                     [](const std::string& name) { return find_metric(name, "").needs_ambient_fit; });
}

bool needs_previous(const std::vector<std::string>& metrics) {
  return std::any_of(metrics.begin(), metrics.end(),
                     [](const std::string& name) { return find_metric(name, "").needs_previous; });
}

const Metric& find_metric(const std::string& name, const std::string& where) {
  std::vector<std::string> known;
  for (const Metric& metric : metrics()) {
    if (metric.name == name) return metric;
    known.push_back(metric.name);
  }
  throw Error(
      "unknown metric '" + name + "'" + did_you_mean(name, known) + "; there are: " + join(known, ", "),
      where);
}

namespace {

MetricValue compute(const Metric& metric, const MetricInput& input) {
  if (metric.needs_baseline && !input.baseline) return MetricValue::undefined("there is no baseline");
  if (metric.needs_ambient_fit && !input.ambient_fit)
    return MetricValue::undefined("the baseline's albedo is not known");
  if (metric.needs_previous && !input.previous)
    return MetricValue::undefined("there is no frame before this one");
  return metric.compute(input);
}

void check_mask(const std::vector<std::uint8_t>* mask, const Image8& reference) {
  if (mask && mask->size() != reference.pixel_count())
    throw Error("the mask has " + std::to_string(mask->size()) + " pixels, the images have " +
                std::to_string(reference.pixel_count()));
}

}  // namespace

std::map<std::string, MetricValue> compute_metrics(const std::vector<std::string>& names,
                                                   const MetricInput& input) {
  check_pair(input.reference, input.image, "the reference", "the image");
  if (input.baseline) check_pair(input.reference, *input.baseline, "the reference", "the baseline");
  check_mask(input.mask, input.reference);
  if (const PreviousFrame* previous = input.previous) {
    check_pair(input.reference, previous->reference, "the reference", "that of the frame before");
    check_pair(input.reference, previous->image, "the reference", "the image of the frame before");
    check_mask(previous->mask, input.reference);
  }
  std::map<std::string, MetricValue> values;
  for (const std::string& name : names) {
    const Metric& metric = find_metric(name, "");
    MetricValue value = compute(metric, input);
    if (value.value && !std::isfinite(*value.value)) value = MetricValue::undefined("not a finite number");
    values[name] = std::move(value);
  }
  return values;
}

void check_pair(const Image8& a, const Image8& b, const std::string& a_name, const std::string& b_name) {
  const auto size = [](const Image8& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
  };
  if (a.empty()) throw Error("the image is empty", a_name);
  if (b.empty()) throw Error("the image is empty", b_name);
  if (a.width != b.width || a.height != b.height)
    throw Error("images of different size: " + a_name + " is " + size(a) + ", " + b_name + " is " + size(b));
  const auto components = [](const Image8& image, const std::string& name) {
    if (image.channels != 3)
      throw Error("expected 3 components a pixel, got " + std::to_string(image.channels), name);
  };
  components(a, a_name);
  components(b, b_name);
}

std::vector<std::uint8_t> object_mask(const Image8& image) {
  std::vector<std::uint8_t> mask(image.pixel_count(), 1);
  if (image.channels != 4) return mask;
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = image.data[4 * i + 3] >= 128;
  return mask;
}

}  // namespace lightbench
