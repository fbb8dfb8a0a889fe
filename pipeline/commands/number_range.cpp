#include "pipeline/commands/number_range.h"

#include <cmath>
#include <cstdlib>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace lightbench {
namespace {

/// The number that all of a text is; NaN where it is none.
double number_of(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size() ? number : std::nan("");
}

}  // namespace

CLI::Validator number_between(double min, double max) {
  const auto check = [min, max](std::string& text) {
    const double number = number_of(text);
    if (std::isfinite(number) && number >= min && number <= max) return std::string();
    return fmt::format("must be a number between {} and {}, not '{}'", min, max, text);
  };
  return {check, fmt::format("between {} and {}", min, max), "number"};
}

}  // namespace lightbench
