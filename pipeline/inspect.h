#pragma once

#include <string>
#include <vector>

#include "pipeline/plan.h"

namespace lightbench {

/// Reads everything that a plan depends on: scenes one after the other, the tools' versions, the OpenGL
/// renderer. A scene that cannot be read, and a tool that is not there, are facts, not errors.
PlanFacts inspect(const Job& job, const std::string& gl);

/// Draws random views of a job's scene: loads it and traces rays.
std::vector<View> draw_job_views(const JobScene& scene, const RandomViewsRequest& request, double aspect);

}  // namespace lightbench
