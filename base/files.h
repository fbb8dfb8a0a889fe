#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/input_file.h"
#include "base/temporary_folder.h"

namespace lightbench {

/// The whole file as bytes. Throws Error with the path when it cannot be read, is not a regular file, or is
/// larger than `largest`.
std::string read_file(const std::filesystem::path& file, std::uint64_t largest = kLargestOwnFile);

/// Makes parent folders, writes beside the target, and renames over it: whole or not there
/// (base/atomic_file.h). Throws Error with the path.
void write_file_atomic(const std::filesystem::path& file, std::string_view bytes);

/// A name from a job or scene file as one path component: letters, digits, and ._- stay (but for leading
/// dots), every other byte becomes %XX, and so do the bytes of `reserved`; never empty, at most 120 bytes
/// (longer ones are cut and end in a hash). Different names give different results.
std::string escape_file_name(std::string_view name, std::string_view reserved = "");

/// Replaces ${NAME} by the environment variable NAME; only names that start with LIGHTBENCH_ are allowed. $${
/// stands for ${ itself. A relative result is taken relative to `base`. Throws Error(…, where) for an unset
/// or a foreign variable.
std::filesystem::path resolve_path(std::string_view text, const std::filesystem::path& base,
                                   const std::string& where);

/// The same for a pattern, in which '{' has a meaning: in `base` and in the values of variables it is
/// doubled, which stands for a brace that is meant as one.
std::string resolve_pattern(std::string_view pattern, const std::filesystem::path& base,
                            const std::string& where);

/// The text from which `resolve_path` makes this path again, and `resolve_pattern` this pattern.
std::string unresolved(std::string_view path);

/// The program's own file.
std::filesystem::path executable_path();

}  // namespace lightbench
