#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

/// The candidate with the smallest edit distance to `name`, if it is near enough to be a misspelling.
std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// " (did you mean 'x'?)", or nothing where no candidate is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

std::string join(const std::vector<std::string>& parts, std::string_view separator);
std::vector<std::string> split(std::string_view text, char separator);
std::string trimmed(std::string_view text);
/// Trimmed, with line breaks as "; ": for messages of other libraries and tools.
std::string one_line(std::string_view text);

/// Whether `name` matches a shell pattern with * ? and [..]; '/' is matched like any other character.
bool matches_glob(std::string_view name, std::string_view pattern);

}  // namespace lightbench
