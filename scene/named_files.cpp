#include "scene/named_files.h"

#include <algorithm>
#include <system_error>

#include "scene/text_scan.h"

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

// Words of a line, of which a few in a row may be the name of a file with blanks.
class WordRuns {
 public:
  WordRuns(std::string_view text, const fs::path& folder) : folder_(folder) {
    std::string_view rest = text;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
      words_.push_back(word);
  }

  std::size_t size() const { return words_.size(); }
  std::string text(std::size_t first, std::size_t end) const {
    const char* const last = words_[end - 1].data() + words_[end - 1].size();
    return {words_[first].data(), last};
  }

  // Where the longest name of a file ends that begins with a word; nothing where none does.
  std::optional<std::size_t> end_of_file(std::size_t first) const {
    constexpr std::size_t kMostWords = 16;
    for (std::size_t end = std::min(size(), first + kMostWords); end > first; --end)
      if (is_named_exactly(text(first, end), folder_)) return end;
    return std::nullopt;
  }

  std::size_t end_of_missing(std::size_t first, std::string_view extension) const {
    std::size_t end = first + 1;
    while (end < size() && !lower_case(words_[end - 1]).ends_with(extension) && !end_of_file(end)) ++end;
    return end;
  }

 private:
  const fs::path& folder_;
  std::vector<std::string_view> words_;
};

// A line of more words names no file: each of them would be looked for.
constexpr std::size_t kMostWordsOnALine = 32;
constexpr std::size_t kShownOfALine = 80;

}  // namespace

std::vector<std::string> names_on_line(const std::string& text, const fs::path& folder,
                                       std::string_view extension) {
  if (is_named_exactly(text, folder)) return {text};
  const std::string uncommented(stripped(without_comment(text)));
  const WordRuns words(uncommented, folder);
  if (words.size() > kMostWordsOnALine) return {uncommented.substr(0, kShownOfALine) + "..."};
  std::vector<std::string> names;
  for (std::size_t first = 0; first < words.size();) {
    const auto end = words.end_of_file(first);
    const std::size_t next = end ? *end : words.end_of_missing(first, extension);
    names.push_back(words.text(first, next));
    first = next;
  }
  if (names.empty()) names.emplace_back();
  return names;
}

std::string with_slashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const bool quoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
  return quoted ? name.substr(1, name.size() - 2) : name;
}

bool is_named_exactly(const std::string& name, const fs::path& folder) {
  const fs::path named = with_slashes(name);
  return can_be_named(named) && is_file((folder / named).lexically_normal());
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
    const auto [entry, is_first] = found->second.try_emplace(lower_case(name), name);
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
    const auto entry = names.find(lower_case(component.string()));
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
