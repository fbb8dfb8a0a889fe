#include "pipeline/own_folder.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"
#include "pipeline/plan_file.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

/// A ledger is read, and refused where it is none, when the run begins. A plan alone, left where the ledger
/// was removed to begin anew, must be one: other programs give their files this name, too.
bool holds_a_run(const fs::path& out) {
  std::error_code error;
  if (fs::exists(fs::symlink_status(out / "ledger.jsonl", error))) return true;
  try {
    read_plan(out / "plan.json");
    return true;
  } catch (const Error&) {
    return false;
  }
}

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
  if (!fs::is_directory(out, error) || holds_a_run(out)) return;
  if (const auto name = foreign_name(out))
    throw Error("holds files, such as " + *name +
                    ", but no run of lightbench: choose an empty folder, a new one or that of an earlier run",
                out.string());
}

}  // namespace lightbench
