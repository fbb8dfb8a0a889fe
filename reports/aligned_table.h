#pragma once

#include <string>
#include <vector>

namespace lightbench {

/// Rows of cells; the first is the heading.
using TextTable = std::vector<std::vector<std::string>>;

/// For a terminal. The first two columns are names and stand on the left, numbers on the right.
std::string aligned(const TextTable& table);

/// Of a name, for a cell of such a table: one line of at most 40 characters.
std::string name_cell(const std::string& text);

}  // namespace lightbench
