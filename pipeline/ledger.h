#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/references.h"
#include "pipeline/task_result.h"

namespace lightbench {

/// The end of one task, as a line of the ledger.
struct LedgerEntry {
  std::string id;
  std::string key;
  KeyParts key_parts;
  Outcome outcome = Outcome::ok;
  std::string error;       ///< of a task that failed
  bool contended = false;  ///< other tasks ran at the same time
  std::string ended;       ///< ISO 8601, UTC
  TaskResult result;       ///< of a task that was done
};

/// A file of lines that are only ever appended, each synced to the disk. While it is open no second run can
/// open it.
class Ledger {
 public:
  /// Opens or makes the file and reads what is there. A last line that a killed run left unfinished is
  /// dropped. Throws Error where another run has it open, it cannot be written, or a line is not one of ours.
  explicit Ledger(const std::filesystem::path& file);
  Ledger(const Ledger&) = delete;
  Ledger& operator=(const Ledger&) = delete;
  ~Ledger();

  void append(const LedgerEntry& entry);
  /// The last entry of each task, by id.
  const std::map<std::string, LedgerEntry>& last() const { return last_; }

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::map<std::string, LedgerEntry> last_;
};

/// Now, as ISO 8601 in UTC.
std::string utc_now();

}  // namespace lightbench
