#pragma once

#include <string>
#include <string_view>

/// What all HTML pages have in common.
namespace lightbench {

extern const char kReportCss[];

/// From the beginning to <body>, with the style.
std::string html_page_start(std::string_view title);

/// Escaped for HTML.
std::string h(std::string_view text);

}  // namespace lightbench
