#include "reports/escape.h"

#include <algorithm>

#include <fmt/format.h>

namespace lightbench {
namespace {

bool ends_in_www(std::string_view text) {
  return text.size() >= 3 &&
         std::all_of(text.end() - 3, text.end(), [](char c) { return c == 'w' || c == 'W'; });
}

template <typename Replace>
std::string replace_bytes(std::string_view text, Replace replace) {
  std::string result;
  result.reserve(text.size() + text.size() / 8);
  for (const char c : text) replace(result, c);
  return result;
}

}  // namespace

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
  constexpr std::string_view kMarkup = "\\`*_{}[]()#+!|~$:";
  return replace_bytes(clean_utf8(text), [&](std::string& result, char c) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '\n' || c == '\t') {
      result += ' ';
    } else if (c == '@') {
      result += "@<!-- -->";  // GFM makes a mail address a link even where '@' is escaped
    } else {
      if (c == '.' && ends_in_www(result)) result += '\\';  // else GFM makes a link of it
      if (kMarkup.find(c) != std::string_view::npos) result += '\\';
      result += c;
    }
  });
}

}  // namespace lightbench
