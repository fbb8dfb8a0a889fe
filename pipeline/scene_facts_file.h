#pragma once

#include <string>

#include "pipeline/plan.h"

namespace lightbench {

/// Writes what planning needs to know of a scene as JSON, for the process that plans.
std::string scene_facts_to_json(const SceneFacts& facts);
/// Reads that text again. Throws Error with the file's name where it is not such a text.
SceneFacts scene_facts_from_json(const std::string& text, const std::string& file);

}  // namespace lightbench
