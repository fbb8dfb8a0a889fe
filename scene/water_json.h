#pragma once

#include "base/json_reader.h"
#include "scene/problem_list.h"
#include "scene/scene.h"

namespace lightbench {

/// Lists what is wrong with its keys; throws Error with the JSON path when it is not an object.
Water read_water(const JsonValue& value, ProblemList& problems);

}  // namespace lightbench
