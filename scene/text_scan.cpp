#include "scene/text_scan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace lightbench {
namespace {

// Larger coordinates overflow when they are squared in 32-bit floats.
constexpr double kLargestNumber = 1e18;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

// nan, -nan(ind), inf, 1.#IND, -1.#QNAN, 1.#J (of "%.2f"): what C libraries print for what is not a number.
bool names_non_finite(std::string_view word) {
  if (word.starts_with('+') || word.starts_with('-')) word.remove_prefix(1);
  const std::string name = lower_case(word);
  constexpr std::array<std::string_view, 5> kNames{"nan", "nanq", "nans", "inf", "infinity"};
  if (std::ranges::find(kNames, name) != kNames.end() || name.starts_with("nan(")) return true;
  return name.find_first_not_of("0123456789") == name.find(".#") && name.find(".#") != name.npos;
}

}  // namespace

std::optional<std::string_view> LineScanner::next() {
  if (next_ >= text_.size()) return std::nullopt;
  start_ = next_;
  ++line_;
  std::size_t end = start_;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r') ++end;
  ended_by_newline_ = end < text_.size();
  const bool crlf = end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n';
  next_ = end + (ended_by_newline_ ? 1 : 0) + (crlf ? 1 : 0);
  return text_.substr(start_, end - start_);
}

std::string_view take_word(std::string_view& rest) {
  std::size_t start = 0;
  while (start < rest.size() && (rest[start] == ' ' || rest[start] == '\t')) ++start;
  std::size_t end = start;
  while (end < rest.size() && rest[end] != ' ' && rest[end] != '\t') ++end;
  const std::string_view word = rest.substr(start, end - start);
  rest.remove_prefix(end);
  return word;
}

std::string_view stripped(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

std::string_view without_comment(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '#' && (i == 0 || text[i - 1] == ' ' || text[i - 1] == '\t')) return text.substr(0, i);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string lowered(text);
  for (char& c : lowered) c = lower(c);
  return lowered;
}

NumberKind classify_number(std::string_view word) {
  std::size_t i = 0;
  if (i < word.size() && (word[i] == '+' || word[i] == '-')) ++i;
  const std::size_t whole_start = i;
  while (i < word.size() && is_digit(word[i])) ++i;
  std::size_t digits = i - whole_start;
  const bool many_digits = digits > 17;
  if (i < word.size() && word[i] == '.') {
    const std::size_t fraction_start = ++i;
    while (i < word.size() && is_digit(word[i])) ++i;
    digits += i - fraction_start;
  }
  bool has_exponent = false;
  if (digits > 0 && i < word.size() && (word[i] == 'e' || word[i] == 'E')) {
    ++i;
    if (i < word.size() && (word[i] == '+' || word[i] == '-')) ++i;
    const std::size_t exponent_start = i;
    while (i < word.size() && is_digit(word[i])) ++i;
    has_exponent = i > exponent_start;
    if (!has_exponent) return NumberKind::malformed;
  }
  if (digits == 0 || i != word.size())
    return names_non_finite(word) ? NumberKind::not_finite : NumberKind::malformed;
  const bool may_be_huge = has_exponent || many_digits;
  return may_be_huge && !(std::abs(number_of(word)) <= kLargestNumber) ? NumberKind::not_finite
                                                                       : NumberKind::finite;
}

double number_of(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  // Infinity, or what is left of a number that is too small.
  if (result.ec == std::errc::result_out_of_range) return std::strtod(std::string(word).c_str(), nullptr);
  return value;
}

}  // namespace lightbench
