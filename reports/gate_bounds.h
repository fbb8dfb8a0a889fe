#pragma once

#include <string>

#include "reports/gate_samples.h"
#include "reports/verdict.h"

/// What a gate's bounds say of a number, and how that is told.
namespace lightbench {

/// Returns by how much a value is outside the bounds; it is negative inside. What is no number is farthest
/// outside.
double excess(const Gate& gate, double value);
bool within(const Gate& gate, double value);

/// ">= 25", "<= 3", "in 1..3".
std::string bounds_text(const Gate& gate);
/// ", below 25" or ", above 3" where the value breaks that bound; else nothing.
std::string broken_bound_text(const Gate& gate, double value);
/// Six digits, as in all details.
std::string gate_number(double value);

/// The difference of errors, of 255, that keeps a sample within the bounds. Its unit must be known.
double margin(const Gate& gate, const GateSample& sample);
/// Whether that is known, and less than the reference's noise.
bool is_within_noise(const Gate& gate, const GateSample& sample);
std::string within_noise_text(double margin, double noise);

}  // namespace lightbench
