#include "base/orphans.h"

#include <vector>

namespace lightbench {
namespace fs = std::filesystem;
namespace {

/// Removes the digits at the start, and returns whether there were any.
bool skip_number(std::string_view& text) {
  const std::size_t end = text.find_first_not_of("0123456789");
  const std::size_t digits = end == std::string_view::npos ? text.size() : end;
  text.remove_prefix(digits);
  return digits > 0;
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type() == fs::file_type::directory;
}

template <typename Iterator>
void remove_found(const fs::path& folder) {
  if (!is_folder(folder)) return;
  std::vector<fs::path> found;
  std::error_code error;
  for (Iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code unknown;
    if (is_temporary_name(entry->path().filename().string()) &&
        entry->symlink_status(unknown).type() == fs::file_type::regular)
      found.push_back(entry->path());
  }
  for (const fs::path& file : found) fs::remove(file, error);
}

}  // namespace

bool is_temporary_name(std::string_view file_name) {
  constexpr std::string_view kMark = ".tmp-";
  const std::size_t mark = file_name.rfind(kMark);
  if (!file_name.starts_with('.') || mark == std::string_view::npos || mark == 0) return false;
  std::string_view rest = file_name.substr(mark + kMark.size());
  if (!skip_number(rest) || !rest.starts_with('-')) return false;
  rest.remove_prefix(1);
  return skip_number(rest) && (rest.empty() || rest.starts_with('.'));
}

void remove_orphans(const fs::path& folder) {
  remove_found<fs::recursive_directory_iterator>(folder);
}

void remove_orphans_in(const fs::path& folder) {
  remove_found<fs::directory_iterator>(folder);
}

}  // namespace lightbench
