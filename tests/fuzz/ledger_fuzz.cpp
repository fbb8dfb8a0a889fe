#include "fuzz_input.h"
#include "pipeline/ledger.h"

namespace lightbench::fuzz {

/// A ledger, looked at and then appended to by a run: the run finds what was there.
void fuzz_ledger(std::string_view bytes) {
  static const InputFolder folder;
  const auto file = folder.write("ledger.jsonl", bytes);
  const Ledger seen(file, LedgerUse::read);
  const Ledger appended(file, LedgerUse::append);
  require(seen.last().size() == appended.last().size(),
          "a run that finds another ledger than those who look");
  for (const auto& [id, entry] : seen.last()) require(id == entry.id, "an entry under another id");
}

}  // namespace lightbench::fuzz
