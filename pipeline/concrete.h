#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/job.h"

namespace lightbench {

/// The most variants and gates of a job, counting all that sweeps make of them.
inline constexpr std::size_t kMaxVariants = 20000;
inline constexpr std::size_t kMaxGates = 20000;

/// How many variants a variant's sweep makes; 1 without one. Throws Error where it makes too many.
std::size_t swept_count(const JobVariant& variant);

/// Variants without sweeps: one for each combination of a sweep's values, named `name[param=value,...]`, the
/// last parameter running fastest. Throws Error where a sweep makes too many.
std::vector<JobVariant> expand_sweeps(const std::vector<JobVariant>& variants);

/// A scene's views as a list.
const std::vector<View>& views_of(const JobScene& scene);

/// The view that shows the frame before a view's own in its sequence, among the views that stand before it.
std::optional<std::size_t> previous_frame(const std::vector<View>& views, std::size_t view);

/// Draws random views of a scene with a given aspect ratio.
using DrawViews =
    std::function<std::vector<View>(const JobScene& scene, const RandomViewsRequest& request, double aspect)>;

/// Where the camera script of drawn views is kept, relative to the run's folder.
std::filesystem::path stored_cameras(const JobScene& scene);

/// The job with nothing left to decide: every scene's views are a list of still ones, and no variant has a
/// sweep. Of a scene with a sequence each view becomes its frames, `name.000`, `name.001` and so on. Camera
/// scripts are read; drawn views are stored as a camera script in the run's folder and read back from it, so
/// that a repetition from the stored script has the same views to the bit. Throws Error for scripts that
/// cannot be read and for gates that match no view; where views need not be drawn, before any is.
Job make_concrete(const Job& job, const std::filesystem::path& out, const DrawViews& draw_views);

}  // namespace lightbench
