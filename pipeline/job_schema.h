#pragma once

#include <string>

namespace lightbench {

/// The JSON schema (draft 7) of job files. What it lists comes from the tables of techniques, metrics and
/// references.
std::string job_schema_text();

}  // namespace lightbench
