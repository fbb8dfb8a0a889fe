#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

/// The candidate with the smallest edit distance to `name`, if it is near enough to be a misspelling.
std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// " (did you mean 'x'?)", or nothing where no candidate is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);
/// The same with the keys of a map as candidates.
template <typename Value>
std::string did_you_mean(std::string_view name, const std::map<std::string, Value>& candidates) {
  std::vector<std::string> names;
  for (const auto& [key, unused] : candidates) names.push_back(key);
  return did_you_mean(name, names);
}

std::string join(const std::vector<std::string>& parts, std::string_view separator);
std::vector<std::string> split(std::string_view text, char separator);
std::string trimmed(std::string_view text);
/// Trimmed, with line breaks as "; ": for messages of other libraries and tools.
std::string one_line(std::string_view text);

/// The last lines of what a program said, trimmed and without blank ones; of a long line only its start.
std::vector<std::string> last_lines(std::string_view text, std::size_t count);

/// Whether a text has a wildcard of shell patterns: * ? or [. A backslash alone is none, since names have
/// them.
bool is_pattern(std::string_view text);
/// Whether `name` matches a shell pattern with * ? and [..]; '/' is matched like any other character. A
/// backslash takes the meaning of the character after it.
bool matches_glob(std::string_view name, std::string_view pattern);

}  // namespace lightbench
