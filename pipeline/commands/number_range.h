#pragma once

#include <CLI/App.hpp>

namespace lightbench {

/// What every option that is a number is checked with: finite, decimal, without blanks, and
/// min <= x <= max. (CLI::Range lets NaN, hexadecimal numbers and blanks before them pass.)
CLI::Validator number_between(double min, double max);

}  // namespace lightbench
