#pragma once

#include <vector>

#include "renderer/path_tracer.h"
#include "renderer/paths/path_scene.h"

namespace lightbench::bench {

/// The picture of trace_paths as a plain loop makes it: ray by ray with rtcIntersect1 and rtcOccluded1, path
/// by path, one thread, no supersampling; light points all asked. The same random numbers and the same
/// equations, so that the difference is rounding.
std::vector<glm::vec3> plain_path_trace(const Scene& scene, const View& view, int width, int height,
                                        const PathTracerOptions& options);

}  // namespace lightbench::bench
