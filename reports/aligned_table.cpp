#include "reports/aligned_table.h"

#include <algorithm>

#include "reports/escape.h"

namespace lightbench {
namespace {

constexpr std::size_t kNameWidth = 40;

std::string spaces(std::size_t count) {
  return std::string(count, ' ');
}

}  // namespace

std::string aligned(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (const auto& row : table) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(row[i]));
  }
  std::string text;
  for (const auto& row : table) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding = spaces(widths[i] - display_width(row[i]));
      line += (i == 0 ? "" : "  ") + (i < 2 ? row[i] + padding : padding + row[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string name_cell(const std::string& text) {
  return shortened(plain_line(text), kNameWidth);
}

}  // namespace lightbench
