#include "pipeline/cache.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"

namespace lightbench {
namespace {

const LedgerEntry* entry_of(const Task& task, const std::map<std::string, LedgerEntry>& entries) {
  const auto found = entries.find(task.id);
  return found == entries.end() ? nullptr : &found->second;
}

}  // namespace

std::string changed_parts(const KeyParts& before, const KeyParts& now) {
  const std::map<std::string, std::string> old_parts(before.begin(), before.end());
  const std::map<std::string, std::string> new_parts(now.begin(), now.end());
  std::vector<std::string> names;
  for (const auto& [name, value] : now) {
    const auto found = old_parts.find(name);
    if (found == old_parts.end())
      names.push_back(name + " (new)");
    else if (found->second != value)
      names.push_back(name);
  }
  for (const auto& [name, value] : before)
    if (!new_parts.contains(name)) names.push_back(name + " (gone)");
  return names.empty() ? "the order of its parts" : join(names, ", ");
}

std::string FolderCache::damage(const Task& task, const LedgerEntry& entry) const {
  for (const auto& file : task.outputs)
    if (!entry.result.outputs.contains(file)) return file + " was not made";
  for (const auto& [file, hash] : entry.result.outputs) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(out_ / file, error)) return file + " is missing";
    try {
      if (hash_file(out_ / file) != hash) return file + " was changed";
    } catch (const Error& unreadable) {
      return unreadable.what();
    }
  }
  return "";
}

std::optional<LedgerEntry> FolderCache::find(const Task& task) {
  const LedgerEntry* entry = entry_of(task, ledger_.last_done());
  if (!entry || entry->key != task.key) return std::nullopt;
  if (!damage(task, *entry).empty()) return std::nullopt;
  return *entry;
}

std::string FolderCache::why_missing(const Task& task) {
  const LedgerEntry* entry = entry_of(task, ledger_.last());
  if (!entry) return "never done";
  if (entry->outcome != Outcome::ok) return "failed the last time";
  if (entry->key != task.key) return "changed: " + changed_parts(entry->key_parts, task.key_parts);
  return damage(task, *entry);
}

std::optional<std::string> FolderCache::last_failure(const Task& task) {
  const LedgerEntry* entry = entry_of(task, ledger_.last());
  if (!entry || entry->outcome == Outcome::ok || entry->key != task.key) return std::nullopt;
  return entry->error;
}

std::optional<double> FolderCache::last_seconds(const Task& task) {
  const LedgerEntry* entry = entry_of(task, ledger_.last_done());
  if (!entry) return std::nullopt;
  return entry->result.seconds;
}

void FolderCache::record(const LedgerEntry& entry) {
  ledger_.append(entry);
}

}  // namespace lightbench
