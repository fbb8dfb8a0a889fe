#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/job.h"

namespace lightbench {

/// Variants without sweeps: one for each combination of a sweep's values, named `name[param=value,...]`, the
/// last parameter running fastest. Throws Error where a sweep makes too many.
std::vector<JobVariant> expand_sweeps(const std::vector<JobVariant>& variants);

/// A scene's views as a list.
const std::vector<View>& views_of(const JobScene& scene);

/// Draws random views of a scene with a given aspect ratio.
using DrawViews =
    std::function<std::vector<View>(const JobScene& scene, const RandomViewsRequest& request, double aspect)>;

/// Where the camera script of drawn views is kept, relative to the run's folder.
std::filesystem::path stored_cameras(const JobScene& scene);

/// The job with nothing left to decide: every scene's views are a list, and no variant has a sweep. Camera
/// scripts are read; drawn views are stored as a camera script in the run's folder and read back from it, so
/// that a repetition from the stored script has the same views to the bit.
Job make_concrete(const Job& job, const std::filesystem::path& out, const DrawViews& draw_views);

}  // namespace lightbench
