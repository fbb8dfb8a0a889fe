#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/image.h"

namespace lightbench {

/// What a metric sees: 8-bit sRGB images of one size with three components (Error otherwise, by `check_pair`).
struct MetricInput {
  const Image8& reference;
  const Image8& image;
  const Image8* baseline = nullptr;            ///< for metrics with needs_baseline
  const std::vector<std::uint8_t>* mask = nullptr;  ///< one byte a pixel, non-zero counts; for masked metrics
};

/// A number, or the reason why there is none. An undefined value never passes a gate.
struct MetricValue {
  std::optional<double> value;
  std::string undefined_because;

  static MetricValue of(double v) { return {v, {}}; }
  static MetricValue undefined(std::string reason) { return {std::nullopt, std::move(reason)}; }
};

enum class Better { lower, higher, neither };

/// One file pair in metrics/ and one row in metrics.cpp.
struct Metric {
  std::string name;
  std::string doc;
  std::string unit;      ///< "of 255", "%", "" ...
  Better better = Better::lower;
  bool needs_baseline = false;
  bool masked = false;   ///< computed over the mask's pixels where one is given
  int version = 1;
  int decimals = 4;      ///< shown in tables
  MetricValue (*compute)(const MetricInput& input) = nullptr;
};

std::span<const Metric> metrics();
const Metric& find_metric(const std::string& name, const std::string& where);

/// Throws Error where the images differ in size (naming both), or are empty.
void check_pair(const Image8& a, const Image8& b, const std::string& a_name, const std::string& b_name);

}  // namespace lightbench
