#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Names and messages come from files and other programs: before people read them, what is not plain text in
/// them is replaced.
namespace lightbench {

/// Length of the well-formed UTF-8 sequence at the start of `text` (no surrogates, nothing overlong), or 0.
std::size_t utf8_sequence_length(std::string_view text);

/// Bytes that are not UTF-8, and code points that XML forbids (control characters but tab and line feed,
/// U+FFFE, U+FFFF), that end a line (U+2028, U+2029) or that turn the order of what follows them (U+200E, U+200F, U+202A to U+202E, U+2066 to
/// U+2069), become U+FFFD. A carriage return becomes a line feed.
std::string clean_utf8(std::string_view text);

/// The same as a single line: tabs and line feeds become spaces.
std::string plain_line(std::string_view text);

/// Columns that UTF-8 text takes, one for each code point.
std::size_t display_width(std::string_view text);

/// At most `characters` code points of UTF-8 text, the last being an ellipsis where something was cut.
std::string shortened(std::string_view text, std::size_t characters);

}  // namespace lightbench
