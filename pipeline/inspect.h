#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/plan.h"

namespace lightbench {

/// Returns the facts of all scenes of a concrete job, in their order.
using InspectScenes = std::function<std::vector<SceneFacts>(const Job& job)>;

/// Reads everything that a plan depends on: the scenes, the tools' versions, the OpenGL renderer. A scene
/// that cannot be read, and a tool that is not there, are facts, not errors.
PlanFacts inspect(const Job& job, const std::string& gl, const InspectScenes& inspect_scenes);

/// Reads one scene of a concrete job in this process.
SceneFacts inspect_scene(const Job& job, const JobScene& job_scene);

/// Returns the name and the hash of each file that was read of a scene.
KeyParts file_parts(const Scene& scene);

/// Draws random views of a job's scene: loads it and traces rays.
std::vector<View> draw_job_views(const JobScene& scene, const RandomViewsRequest& request, double aspect);

/// Draws random views of a scene where its entities stand now.
std::vector<View> draw_views(const Scene& scene, const RandomViewsRequest& request, double aspect);

}  // namespace lightbench
