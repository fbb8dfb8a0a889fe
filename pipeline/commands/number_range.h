#pragma once

#include <CLI/App.hpp>

namespace lightbench {

/// What every option that is a number is checked with: finite, and min <= x <= max. (CLI::Range lets NaN
/// pass.)
CLI::Validator number_between(double min, double max);

}  // namespace lightbench
