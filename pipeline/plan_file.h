#pragma once

#include <filesystem>
#include <string>

#include "pipeline/plan.h"

namespace lightbench {

inline constexpr int kPlanFormatVersion = 2;

/// The plan as versioned JSON, for workers and for people; and back.
std::string plan_to_json(const Plan& plan);
/// Throws Error where the file is of another version, or not a plan, or points at what its job has not.
Plan read_plan(const std::filesystem::path& file);

}  // namespace lightbench
