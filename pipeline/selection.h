#pragma once

#include <set>
#include <string>
#include <vector>

#include "pipeline/ledger.h"
#include "pipeline/plan.h"

/// Parts of a run: one flag for each task of the plan.
namespace lightbench {

/// Whether a label, such as scene/view/variant, matches the pattern, or begins with it as a path; empty: any.
bool is_selected(const std::string& label, const std::string& only);

/// Which tasks --stages and --only choose: those of the named kinds (none: all) whose label is
/// selected, and what they need of those kinds. An export comes with its reference, and baked
/// objects with the snapshots that draw them.
std::vector<bool> select_tasks(const Plan& plan, const std::set<TaskKind>& stages, const std::string& only);

/// Which tasks --retry-failed chooses: those that failed the last time, what was skipped because of them, and
/// what all of these need.
std::vector<bool> select_failed(const Plan& plan, const std::map<std::string, LedgerEntry>& last);

}  // namespace lightbench
