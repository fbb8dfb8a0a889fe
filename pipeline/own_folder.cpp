#include "pipeline/own_folder.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

/// One of these is in the folder of every run, even where the other was removed to begin anew.
constexpr std::array<const char*, 2> kOfARun{"ledger.jsonl", "plan.json"};
/// What other commands write into the folder of a run that there is not yet.
constexpr std::array<std::string_view, 2> kBeforeARun{"bench.json", "oracle.json"};

bool is_foreign(const std::string& name) {
  return !name.starts_with('.') && std::ranges::find(kBeforeARun, name) == kBeforeARun.end();
}

/// The first by name, so that the message is the same each time.
std::optional<std::string> foreign_name(const fs::path& folder) {
  std::optional<std::string> first;
  std::error_code error;  // who cannot list the folder learns of it where the run begins
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (const std::string name = entry->path().filename().string();
        is_foreign(name) && (!first || name < *first))
      first = name;
  return first;
}

}  // namespace

void check_own_folder(const fs::path& out) {
  std::error_code error;
  const auto is_there = [&](const char* name) { return fs::exists(fs::symlink_status(out / name, error)); };
  if (!fs::is_directory(out, error) || std::ranges::any_of(kOfARun, is_there)) return;
  if (const auto name = foreign_name(out))
    throw Error("holds files, such as " + *name +
                    ", but no run of lightbench: choose an empty folder, a new one or that of an earlier run",
                out.string());
}

}  // namespace lightbench
