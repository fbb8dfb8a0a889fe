#pragma once

#include <string>
#include <string_view>

#include "base/utf8.h"

/// Names and messages come from files and other programs: each report escapes them for its own language.
namespace lightbench {

/// For HTML and XML text and quoted attributes alike.
std::string escape_markup(std::string_view text);

/// A path relative to the page as a URL: everything but letters, digits and "-._~/" is percent-encoded, so
/// that it can hold no scheme, query or fragment; it never starts with a slash.
std::string relative_url(std::string_view path);

/// JSON text that may stand in a <script> element.
std::string escape_json_for_script(std::string_view json);

/// For one cell of a Markdown table: a single line in which nothing is markup, and no address becomes a link
/// by itself.
std::string escape_markdown(std::string_view text);

}  // namespace lightbench
