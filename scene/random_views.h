#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace lightbench {

struct RayHit {
  float distance;    ///< in units of the direction's length
  glm::vec3 normal;  ///< geometric, unit, not flipped towards the ray's origin
};

/// The closest hit of a ray from origin along a unit direction. The caller traces it (renderer/rays).
using ClosestHit = std::function<std::optional<RayHit>(const glm::vec3& origin, const glm::vec3& direction)>;

/// Which generator draws. Each version draws the same views for ever; a better one becomes a new version.
inline constexpr int kNewestGenerator = 2;

struct RandomViewOptions {
  int count = 1;
  std::uint64_t seed = 1;
  float fov = 1.0471976f;  ///< vertical, radians
  float aspect = 4.0f / 3.0f;
  int version = kNewestGenerator;
};

/// Draws `count` valid views, named random-SEED-0001 and so on; the same for the same scene and options, and
/// beginning alike however many are drawn. A view is valid when rays say that it is not inside geometry or in
/// its face, is not mostly background, and (from version 2 on) that light reaches what it shows; version 2
/// also spreads them over the scene. Throws Error where no valid view is found in a stated number of tries.
std::vector<View> draw_random_views(const Scene& scene, const RandomViewOptions& options,
                                    const ClosestHit& closest_hit);

/// Why the view is not valid by the rules of that version at their strictest, or nothing.
std::optional<std::string> why_view_is_invalid(const Scene& scene, const View& view, float aspect,
                                               const ClosestHit& closest_hit, int version = kNewestGenerator);

}  // namespace lightbench
