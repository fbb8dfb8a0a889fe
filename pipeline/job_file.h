#pragma once

#include <filesystem>
#include <string>

#include "pipeline/job.h"

namespace lightbench {

/// Reads a job file (JSON with comments). Relative paths are taken from the file's folder. Throws Error with
/// the JSON path, and the nearest known name, for unknown keys, techniques, parameters, metrics, variants and
/// so on; one Error has all that is wrong in the file. Scene and camera files are only named, not read.
Job read_job(const std::filesystem::path& file);
/// A job as somebody wrote it, or as a plan has it: its names were checked before, and those that a sweep
/// made may be long.
enum class JobText { written, concrete };

/// The same from text; `file` stands in errors and gives the folder of relative paths.
Job parse_job(const std::string& text, const std::filesystem::path& file, JobText kind = JobText::written);

/// The job as text that `parse_job` reads back to the same values, with paths made absolute.
std::string job_text(const Job& job);

}  // namespace lightbench
