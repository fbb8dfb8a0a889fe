#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lightbench {

/// Where the file that an OBJ or MTL names is; `found_elsewhere` where it has not quite that name.
struct FoundFile {
  std::filesystem::path file;
  bool found_elsewhere = false;
};

/// Finds the files that OBJ and MTL files name. Folders are listed once, however many names are looked for.
class NamedFiles {
 public:
  /// Backslashes count as slashes. Where nothing has that name, a file that differs in case only is taken, or
  /// one of its last component beside `folder` (a path of somebody else's machine). Nothing if there is none.
  std::optional<FoundFile> find(const std::string& name, const std::filesystem::path& folder);

 private:
  /// Names in lower case to the names as they are; the first of several in order.
  using Entries = std::map<std::string, std::string>;

  const Entries& entries(const std::filesystem::path& folder);
  std::optional<std::filesystem::path> path_ignoring_case(const std::filesystem::path& folder,
                                                          const std::filesystem::path& relative);

  std::map<std::filesystem::path, Entries> folders_;
};

/// Whether there is a file of exactly that name, but for backslashes and quotes.
bool is_named_exactly(const std::string& name, const std::filesystem::path& folder);

/// Why `find` found nothing: "is missing", or "is not a regular file" of what has exactly that name.
std::string why_not_found(const std::string& name, const std::filesystem::path& folder);

/// The names of files on a line, which are separated by blanks and may have blanks: as long as can be where a
/// file has exactly that name. One that is missing ends with `extension`, or before one that is there.
std::vector<std::string> names_on_line(const std::string& text, const std::filesystem::path& folder,
                                       std::string_view extension);

/// The name with slashes and without quotes.
std::string with_slashes(std::string name);

}  // namespace lightbench
