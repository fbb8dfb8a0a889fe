#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/random_views.h"
#include "scene/scene.h"

/// The generators of random views. Once released, a version stays as it is: jobs that name it must get the
/// same views for ever, so what is better becomes another version.
namespace lightbench {

namespace views_1 {
std::vector<Camera> draw_cameras(const Scene& scene, const RandomViewOptions& options,
                                 const ClosestHit& closest_hit);
std::optional<std::string> why_invalid(const Scene& scene, const Camera& camera, float aspect,
                                       const ClosestHit& closest_hit);
}  // namespace views_1

namespace views_2 {
std::vector<Camera> draw_cameras(const Scene& scene, const RandomViewOptions& options,
                                 const ClosestHit& closest_hit);
std::optional<std::string> why_invalid(const Scene& scene, const Camera& camera, float aspect,
                                       const ClosestHit& closest_hit);
}  // namespace views_2

}  // namespace lightbench
