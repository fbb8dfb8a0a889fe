#include "scene/named_files.h"

#include <algorithm>
#include <system_error>

namespace lightbench {
namespace fs = std::filesystem;
namespace {

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool can_be_named(const fs::path& named) {
  return !named.empty() && named.string().find('\0') == std::string::npos;
}

std::string in_lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return text;
}

}  // namespace

std::string with_slashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const bool quoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
  return quoted ? name.substr(1, name.size() - 2) : name;
}

std::string why_not_found(const std::string& name, const fs::path& folder) {
  const fs::path named = with_slashes(name);
  std::error_code ignored;
  const bool is_there = can_be_named(named) && fs::exists((folder / named).lexically_normal(), ignored);
  return is_there ? "is not a regular file" : "is missing";
}

const NamedFiles::Entries& NamedFiles::entries(const fs::path& folder) {
  const auto [found, inserted] = folders_.try_emplace(folder);
  if (!inserted) return found->second;
  std::error_code error;
  for (fs::directory_iterator it(folder.empty() ? fs::path(".") : folder, error), end; !error && it != end;
       it.increment(error)) {
    const std::string name = it->path().filename().string();
    const auto [entry, is_first] = found->second.try_emplace(in_lower_case(name), name);
    if (!is_first) entry->second = std::min(entry->second, name);
  }
  return found->second;
}

// The path with each component found but for case.
std::optional<fs::path> NamedFiles::path_ignoring_case(const fs::path& folder, const fs::path& relative) {
  fs::path path = folder;
  for (const fs::path& component : relative) {
    if (component == "." || component == "..") {
      path /= component;
      continue;
    }
    const Entries& names = entries(path);
    const auto entry = names.find(in_lower_case(component.string()));
    if (entry == names.end()) return std::nullopt;
    path /= entry->second;
  }
  return is_file(path) ? std::optional(path) : std::nullopt;
}

std::optional<FoundFile> NamedFiles::find(const std::string& name, const fs::path& folder) {
  const fs::path named = with_slashes(name);
  if (!can_be_named(named)) return std::nullopt;
  if (const fs::path exact = (folder / named).lexically_normal(); is_file(exact))
    return FoundFile{exact, false};
  if (named.is_relative())
    if (const auto path = path_ignoring_case(folder, named)) return FoundFile{path->lexically_normal(), true};
  if (named.filename().empty()) return std::nullopt;
  if (const auto path = path_ignoring_case(folder, named.filename())) return FoundFile{*path, true};
  return std::nullopt;
}

}  // namespace lightbench
