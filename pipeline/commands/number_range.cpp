#include "pipeline/commands/number_range.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace lightbench {
namespace {

/// The number that all of a text is, in decimal and without blanks; NaN where it is none.
double number_of(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? number : std::nan("");
}

/// Whether it begins with a zero before another digit, as in 010, which CLI11 takes for the octal 8.
bool looks_octal(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text.size() > 1 && text[0] == '0' && text[1] >= '0' && text[1] <= '9';
}

}  // namespace

CLI::Validator number_between(double min, double max) {
  const auto check = [min, max](const std::string& text) {
    const double number = number_of(text);
    if (!std::isfinite(number) || number < min || number > max)
      return fmt::format("must be a number between {} and {}, not '{}'", min, max, text);
    if (looks_octal(text)) return fmt::format("write the number without zeros in front: '{}'", text);
    return std::string();
  };
  return {check, fmt::format("between {} and {}", min, max), "number"};
}

}  // namespace lightbench
