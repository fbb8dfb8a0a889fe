#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/image.h"

namespace lightbench {

/// The frame before, in a sequence; images as in MetricInput.
struct PreviousFrame {
  const Image8& reference;
  const Image8& image;
  const std::vector<std::uint8_t>* mask = nullptr;
};

/// What a metric sees: 8-bit sRGB images of one size with three components, checked by `check_pair`.
struct MetricInput {
  const Image8& reference;
  const Image8& image;
  const Image8* baseline = nullptr;                 ///< for metrics with needs_baseline
  const std::vector<std::uint8_t>* mask = nullptr;  ///< one byte a pixel, non-zero counts; for masked metrics
  const Image8* ambient_fit = nullptr;              ///< for metrics with needs_ambient_fit
  const PreviousFrame* previous = nullptr;          ///< for metrics with needs_previous
};

/// A number, or the reason why there is none. An undefined value never passes a gate.
struct MetricValue {
  std::optional<double> value;
  std::string undefined_because;

  static MetricValue of(double v) { return {v, {}}; }
  static MetricValue undefined(std::string reason) { return {std::nullopt, std::move(reason)}; }

  bool operator==(const MetricValue&) const = default;
};

enum class Better { lower, higher, neither };

/// What a difference of 1 in a metric is as a difference of mean errors, to be compared with a reference's
/// noise.
enum class NoiseUnit { none, error, percent_of_baseline };

/// One file pair in metrics/ and one row in metrics.cpp.
struct Metric {
  std::string name;
  std::string doc;
  std::string unit;  ///< "of 255", "%", "" ...
  Better better = Better::lower;
  bool needs_baseline = false;
  bool needs_ambient_fit =
      false;  ///< of the baseline's light and albedo; such metrics are computed on request only
  bool needs_previous = false;  ///< of the frame before; such metrics are computed where a job has sequences
  bool on_request = false;      ///< a job computes it where it names it, so that its other numbers stay alike
  bool masked = false;          ///< computed over the mask's pixels where one is given
  NoiseUnit noise_unit = NoiseUnit::none;
  int version = 1;   ///< goes up whenever the same images may give another number
  int decimals = 4;  ///< shown in tables
  MetricValue (*compute)(const MetricInput& input) = nullptr;
};

std::span<const Metric> metrics();
/// The names of those that a job computes unless it asks for others.
std::vector<std::string> default_metrics();
/// Those that look at the frame before: a job with sequences has them beside the default ones.
std::vector<std::string> sequence_metrics();
bool needs_ambient_fit(const std::vector<std::string>& metrics);
bool needs_previous(const std::vector<std::string>& metrics);
/// Throws Error(..., where) for an unknown name, with the nearest known one and all that there are.
const Metric& find_metric(const std::string& name, const std::string& where);

/// The named metrics of one pair. A metric that needs a baseline, or the frame before, where there is none is
/// undefined, and so is one that comes out as NaN or infinity. Throws Error for an unknown name, images that
/// do not fit together
/// (`check_pair`), or a mask of another size.
std::map<std::string, MetricValue> compute_metrics(const std::vector<std::string>& names,
                                                   const MetricInput& input);

/// Throws Error where the images differ in size (naming both), are empty, or have not three components.
void check_pair(const Image8& a, const Image8& b, const std::string& a_name, const std::string& b_name);

/// The pixels that objects cover by at least half, for MetricInput::mask: those whose fourth component is 128
/// or more. All pixels where the image has no fourth component.
std::vector<std::uint8_t> object_mask(const Image8& image);

}  // namespace lightbench
