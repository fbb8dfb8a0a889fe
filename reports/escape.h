#pragma once

#include <string>
#include <string_view>

/// Names and messages come from files and other programs: each report escapes them for its own language.
namespace lightbench {

/// Bytes that are not UTF-8, and code points that XML forbids (control characters but tab and line feed,
/// U+FFFE, U+FFFF), become U+FFFD. A carriage return becomes a line feed.
std::string clean_utf8(std::string_view text);

/// For HTML and XML text and quoted attributes alike.
std::string escape_markup(std::string_view text);

/// A path relative to the page as a URL: everything but letters, digits and "-._~/" is percent-encoded, so
/// that it can hold no scheme, query or fragment; it never starts with a slash.
std::string relative_url(std::string_view path);

/// JSON text that may stand in a <script> element.
std::string escape_json_for_script(std::string_view json);

/// For one cell of a Markdown table: a single line in which nothing is markup.
std::string escape_markdown(std::string_view text);

/// For a terminal: a single line without control characters.
std::string plain_line(std::string_view text);

/// Columns that UTF-8 text takes, one for each code point.
std::size_t display_width(std::string_view text);

/// At most `characters` code points of UTF-8 text, the last being an ellipsis where something was cut.
std::string shortened(std::string_view text, std::size_t characters);

}  // namespace lightbench
