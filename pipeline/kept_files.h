#pragma once

#include <filesystem>
#include <vector>

#include "base/file_clashes.h"
#include "pipeline/plan.h"

/// A run must not replace what it reads.
namespace lightbench {

/// Returns the job file, its scene files and its camera scripts.
std::vector<NamedFile> job_files(const Job& job);

/// Returns all files that a run of the concrete job reads: its own, those of its scenes, and other engines'
/// pictures.
std::vector<NamedFile> read_files(const Job& job, const PlanFacts& facts);

/// Returns the files that every run writes beside those of its tasks.
std::vector<NamedFile> run_files(const std::filesystem::path& out);

/// Throws Error, with the path, where the run would replace a file that it reads, or where something that is
/// no file, such as a folder, stands in the place of a file that the run writes.
void check_outputs_of(const Plan& plan, const PlanFacts& facts);

}  // namespace lightbench
