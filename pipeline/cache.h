#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/ledger.h"
#include "pipeline/plan.h"

namespace lightbench {

/// Where results of earlier runs are looked up and new ones are kept.
class Cache {
 public:
  virtual ~Cache() = default;
  /// The result with the task's key, its outputs being in the run's folder and whole; or nothing.
  virtual std::optional<LedgerEntry> find(const Task& task) = 0;
  /// Why `find` gave nothing: which part of the key changed, or which file is missing or damaged.
  virtual std::string why_missing(const Task& task) = 0;
  /// Why the task failed when it was last tried, if it did, and with the same key.
  virtual std::optional<std::string> last_failure(const Task& task) = 0;
  /// Seconds that the task took the last time, whatever its key was.
  virtual std::optional<double> last_seconds(const Task& task) = 0;
  virtual void record(const LedgerEntry& entry) = 0;
};

/// The run's own folder as the cache: the ledger says what was made and with which checksum.
class FolderCache : public Cache {
 public:
  FolderCache(Ledger& ledger, std::filesystem::path out) : ledger_(ledger), out_(std::move(out)) {}

  std::optional<LedgerEntry> find(const Task& task) override;
  std::string why_missing(const Task& task) override;
  std::optional<std::string> last_failure(const Task& task) override;
  std::optional<double> last_seconds(const Task& task) override;
  void record(const LedgerEntry& entry) override;

 private:
  std::string damage(const Task& task, const LedgerEntry& entry) const;

  Ledger& ledger_;
  std::filesystem::path out_;
};

/// The names of the key's parts that differ: "view, parameters"; parts that came or went are named as such.
std::string changed_parts(const KeyParts& before, const KeyParts& now);

}  // namespace lightbench
