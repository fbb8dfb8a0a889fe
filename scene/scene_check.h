#pragma once

#include <filesystem>

#include "scene/problem_list.h"
#include "scene/scene.h"

namespace lightbench {

/// What is wrong or odd about a scene as a whole, beyond its files: nothing to see, nothing that lights it,
/// lights that reach nothing or lie in a surface, materials that give back more light than they get.
void check_scene(const Scene& scene, const std::filesystem::path& file, ProblemList& problems);

}  // namespace lightbench
