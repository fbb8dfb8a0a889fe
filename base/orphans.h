#pragma once

#include <filesystem>
#include <string_view>

namespace lightbench {

/// Whether AtomicFile gives such names to files that are not in place yet.
bool is_temporary_name(std::string_view file_name);

/// Removes the files in the folder and below it that a killed process had not put in place yet, without
/// following links. Only for who knows that no process writes there now. What cannot be removed stays.
void remove_orphans(const std::filesystem::path& folder);
/// Does so in the folder alone, and leaves those below it as they are.
void remove_orphans_in(const std::filesystem::path& folder);

}  // namespace lightbench
