#pragma once

#include <filesystem>

namespace lightbench {

/// Throws Error where a folder that a run is to write to holds files, but no run: a mistyped --out would mix
/// its files with others and replace those of the same name. A folder that is not there, is empty or has
/// hidden files alone, such as .gitkeep, is fine.
void check_own_folder(const std::filesystem::path& out);

}  // namespace lightbench
