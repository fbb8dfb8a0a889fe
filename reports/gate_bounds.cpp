#include "reports/gate_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace lightbench {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double excess(const Gate& gate, double value) {
  if (std::isnan(value)) return kInfinity;
  const double below = gate.min ? *gate.min - value : -kInfinity;
  const double above = gate.max ? value - *gate.max : -kInfinity;
  return std::max(below, above);
}

bool within(const Gate& gate, double value) {
  return (!gate.min || value >= *gate.min) && (!gate.max || value <= *gate.max);
}

std::string gate_number(double value) {
  return fmt::format("{:.6g}", value);
}

std::string bounds_text(const Gate& gate) {
  if (gate.min && gate.max) return fmt::format("in {}..{}", gate_number(*gate.min), gate_number(*gate.max));
  if (gate.min) return ">= " + gate_number(*gate.min);
  return gate.max ? "<= " + gate_number(*gate.max) : "without bounds";
}

std::string broken_bound_text(const Gate& gate, double value) {
  if (gate.min && value < *gate.min) return ", below " + gate_number(*gate.min);
  if (gate.max && value > *gate.max) return ", above " + gate_number(*gate.max);
  return "";
}

double margin(const Gate& gate, const GateSample& sample) {
  return -excess(gate, *sample.value.value) * *sample.unit;
}

bool is_within_noise(const Gate& gate, const GateSample& sample) {
  return sample.noise && sample.unit && margin(gate, sample) < *sample.noise;
}

std::string within_noise_text(double margin, double noise) {
  return fmt::format("by {} of 255, less than the reference's noise of {}", gate_number(margin),
                     gate_number(noise));
}

}  // namespace lightbench
