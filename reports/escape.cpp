#include "reports/escape.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Length of the well-formed UTF-8 sequence at the start of `text` (no surrogates, nothing overlong), or 0.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
  const unsigned first = byte(0), second = byte(1);
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

bool is_forbidden(std::string_view sequence) {
  if (sequence.size() == 1) {
    const auto c = static_cast<unsigned char>(sequence[0]);
    return (c < 0x20 && c != '\t' && c != '\n') || c == 0x7F;
  }
  const bool c1_control = sequence.size() == 2 && sequence[0] == '\xC2' && sequence[1] < '\xA0';
  return c1_control || sequence == "\xEF\xBF\xBE" || sequence == "\xEF\xBF\xBF";
}

template <typename Replace>
std::string replace_bytes(std::string_view text, Replace replace) {
  std::string result;
  result.reserve(text.size() + text.size() / 8);
  for (const char c : text) replace(result, c);
  return result;
}

}  // namespace

std::string clean_utf8(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text.substr(i));
    if (text[i] == '\r') {
      if (i + 1 >= text.size() || text[i + 1] != '\n') result += '\n';
    } else if (length == 0 || is_forbidden(text.substr(i, length))) {
      result += kReplacement;
    } else {
      result += text.substr(i, length);
    }
    i += length == 0 ? 1 : length;
  }
  return result;
}

std::string escape_markup(std::string_view text) {
  return replace_bytes(clean_utf8(text), [](std::string& result, char c) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  });
}

std::string relative_url(std::string_view path) {
  constexpr std::string_view kPlain = "-._~/";
  const std::string encoded = replace_bytes(path, [&](std::string& result, char c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (letter || kPlain.find(c) != std::string_view::npos)
      result += c;
    else
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  });
  return encoded.starts_with('/') ? "." + encoded : encoded;
}

std::string escape_json_for_script(std::string_view json) {
  return replace_bytes(json, [](std::string& result, char c) {
    switch (c) {
      case '<':
        result += "\\u003c";
        break;
      case '>':
        result += "\\u003e";
        break;
      case '&':
        result += "\\u0026";
        break;
      default:
        result += c;
    }
  });
}

std::string escape_markdown(std::string_view text) {
  constexpr std::string_view kMarkup = "\\`*_{}[]()#+!|~$@:";
  return replace_bytes(clean_utf8(text), [&](std::string& result, char c) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '\n' || c == '\t') {
      result += ' ';
    } else {
      if (kMarkup.find(c) != std::string_view::npos) result += '\\';
      result += c;
    }
  });
}

std::string plain_line(std::string_view text) {
  return replace_bytes(clean_utf8(text),
                       [](std::string& result, char c) { result += c == '\n' || c == '\t' ? ' ' : c; });
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
    bytes += std::max<std::size_t>(sequence_length(text.substr(bytes)), 1);
    ++kept;
  }
  return std::string(text.substr(0, bytes)) + "…";
}

}  // namespace lightbench
