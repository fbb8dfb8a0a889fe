#include "base/text.h"

#include <algorithm>

#include <fmt/format.h>
#include <fnmatch.h>

#include "base/utf8.h"

namespace lightbench {
namespace {

/// The edit distance of two texts, or anything above `most` where it is more than that. Distances up to
/// `most` never leave a band of that width along the diagonal, so no more is computed.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most) {
  const std::size_t beyond = most + 1;
  if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) > most) return beyond;
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = std::min(j, beyond);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    const std::size_t first = i > most ? i - most : 1;
    const std::size_t last = std::min(b.size(), i + most);
    std::size_t diagonal = row[first - 1];
    row[first - 1] = first == 1 ? std::min(i, beyond) : beyond;
    std::size_t least = row[first - 1];
    for (std::size_t j = first; j <= last; ++j) {
      const std::size_t substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution, beyond});
      least = std::min(least, row[j]);
    }
    if (least > most) return beyond;
  }
  return row[b.size()];
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const auto& candidate : candidates) {
    if (best_distance == 0) break;
    const std::size_t distance =
        edit_distance(name.substr(0, 200), std::string_view(candidate).substr(0, 200), best_distance - 1);
    if (distance < best_distance && distance < candidate.size()) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates) {
  const auto nearest = nearest_name(name, candidates);
  return nearest ? fmt::format(" (did you mean '{}'?)", *nearest) : "";
}

std::string join(const std::vector<std::string>& parts, std::string_view separator) {
  return fmt::format("{}", fmt::join(parts, separator));
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  for (std::size_t end; (end = text.find(separator, start)) != std::string_view::npos; start = end + 1)
    parts.emplace_back(text.substr(start, end - start));
  parts.emplace_back(text.substr(start));
  return parts;
}

std::string trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

std::string one_line(std::string_view text) {
  std::vector<std::string> lines;
  for (const auto& line : split(text, '\n'))
    if (auto t = trimmed(line); !t.empty()) lines.push_back(std::move(t));
  return join(lines, "; ");
}

std::vector<std::string> last_lines(std::string_view text, std::size_t count) {
  constexpr std::size_t kLongestLine = 500;
  std::vector<std::string> lines;
  for (const auto& line : split(text, '\n'))
    if (auto t = trimmed(line); !t.empty()) lines.push_back(shortened(t, kLongestLine));
  if (lines.size() > count) lines.erase(lines.begin(), lines.end() - std::ptrdiff_t(count));
  return lines;
}

bool is_pattern(std::string_view text) {
  return text.find_first_of("*?[") != std::string_view::npos;
}

bool matches_glob(std::string_view name, std::string_view pattern) {
  if (pattern.find_first_of("*?[\\") == std::string_view::npos) return name == pattern;
  return fnmatch(std::string(pattern).c_str(), std::string(name).c_str(), 0) == 0;
}

}  // namespace lightbench
