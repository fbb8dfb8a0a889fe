#include "reports/formats/html_page.h"

#include <fmt/format.h>

#include "reports/escape.h"

namespace lightbench {

std::string h(std::string_view text) {
  return escape_markup(text);
}

std::string html_page_start(std::string_view title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{} · lightbench</title>\n"
      "<style>\n{}</style>\n</head>\n<body>\n",
      h(title), kReportCss);
}

}  // namespace lightbench
