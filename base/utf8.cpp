#include "base/utf8.h"

#include <algorithm>

namespace lightbench {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// The code point of a well-formed sequence.
unsigned code_point(std::string_view sequence) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(sequence[i]); };
  if (sequence.size() == 1) return byte(0);
  unsigned result = byte(0) & (0x7Fu >> sequence.size());
  for (std::size_t i = 1; i < sequence.size(); ++i) result = result << 6 | (byte(i) & 0x3Fu);
  return result;
}

bool is_control(unsigned code) {
  return (code < 0x20 && code != '\t' && code != '\n') || (code >= 0x7F && code < 0xA0);
}

/// Marks after which a terminal or browser shows text in another order than it is written in.
bool turns_the_order(unsigned code) {
  return code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// Line and paragraph separators, which some programs show as the end of a line.
bool ends_a_line(unsigned code) {
  return code == 0x2028 || code == 0x2029;
}

bool is_forbidden(std::string_view sequence) {
  const unsigned code = code_point(sequence);
  return is_control(code) || ends_a_line(code) || turns_the_order(code) || code == 0xFFFE || code == 0xFFFF;
}

}  // namespace

std::size_t utf8_sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
  const unsigned first = byte(0), second = byte(1);
  if (text.empty()) return 0;
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return continues(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    if (first == 0xE0 && second < 0xA0) return 0;
    if (first == 0xED && second > 0x9F) return 0;
    return continues(1) && continues(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    if (first == 0xF0 && second < 0x90) return 0;
    if (first == 0xF4 && second > 0x8F) return 0;
    return continues(1) && continues(2) && continues(3) ? 4 : 0;
  }
  return 0;
}

std::string clean_utf8(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_sequence_length(text.substr(i));
    if (text[i] == '\r') {
      if (i + 1 >= text.size() || text[i + 1] != '\n') result += '\n';
    } else if (length == 0 || is_forbidden(text.substr(i, length))) {
      result += kReplacement;
    } else {
      result += text.substr(i, length);
    }
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string plain_line(std::string_view text) {
  std::string result = clean_utf8(text);
  for (char& c : result)
    if (c == '\n' || c == '\t') c = ' ';
  return result;
}

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for (const char c : text) width += (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
  return width;
}

std::string shortened(std::string_view text, std::size_t characters) {
  if (display_width(text) <= characters) return std::string(text);
  std::size_t bytes = 0, kept = 0;
  while (bytes < text.size() && kept + 1 < characters) {
    bytes += std::max<std::size_t>(utf8_sequence_length(text.substr(bytes)), 1);
    ++kept;
  }
  return std::string(text.substr(0, bytes)) + "…";
}

}  // namespace lightbench
