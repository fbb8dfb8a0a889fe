#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/descriptors.h"
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

enum class LedgerUse {
  append,  ///< by a run: makes the file, and no second run can open it meanwhile
  read,    ///< only to look: a file that is not there is empty
};

/// A file of lines that are only ever appended, each synced to the disk.
class Ledger {
 public:
  /// Reads what is there. A last line that a killed run left unfinished is dropped. Throws Error, and leaves
  /// the file as it is, where another run appends to it, it cannot be written, it is not a regular file (a
  /// link or a device, say), it has a second name (a hard link) under which it would change too, or it holds
  /// anything but lines of ours.
  Ledger(const std::filesystem::path& file, LedgerUse use);
  Ledger(const Ledger&) = delete;
  Ledger& operator=(const Ledger&) = delete;

  void append(const LedgerEntry& entry);
  /// The last entry of each task, by id.
  const std::map<std::string, LedgerEntry>& last() const { return last_; }
  /// The last entry of each task that was done: a failure since then does not hide it.
  const std::map<std::string, LedgerEntry>& last_done() const { return last_done_; }

 private:
  std::size_t take_lines(const std::string& text);
  void remember(const LedgerEntry& entry);

  std::filesystem::path file_;
  Descriptor descriptor_;
  std::map<std::string, LedgerEntry> last_;
  std::map<std::string, LedgerEntry> last_done_;
};

/// Now, as ISO 8601 in UTC.
std::string utc_now();

}  // namespace lightbench
