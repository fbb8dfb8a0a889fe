#pragma once

#include <optional>
#include <string>

#include "scene/nearest_surface.h"
#include "scene/random_views.h"
#include "scene/scene.h"
#include "scene/views/light_reach.h"
#include "scene/views/ray_survey.h"
#include "scene/views/scene_scale.h"

/// The rules of version 2.
namespace lightbench::views_2 {

/// How much is asked of a view. Where nothing meets the first of these, the next one counts.
struct Strictness {
  double clearance;          ///< of what is asked for
  double most_of_one_plane;  ///< share of the picture
  double fewest_lit;         ///< share of what is in sight that light must reach; 0: not looked at
};
inline constexpr Strictness kStrictness[] = {
    {1, 0.6, 0.25}, {1, 0.85, 0.03}, {0.5, 0.85, 0.03}, {1, 0.85, 0}, {0.25, 0.95, 0},
};

/// A camera's position and what is around it.
struct Place {
  glm::vec3 position;
  Survey around;
  double size;  ///< how far one sees there: the upper quartile of the distances around
};

struct Verdict {
  std::optional<std::string> reason;  ///< why the view is not valid, or nothing
  double quality = 0;  ///< 0..1 of a valid one: how varied its picture is and how much of it is lit
};

/// Judges views of one scene by rays and by the distance of its triangles. Keeps references to all that it is
/// given.
class ViewJudge {
 public:
  ViewJudge(const Scene& scene, const SceneScale& scale, const ClosestHit& closest_hit);

  /// Refuses at once what is nearer to a surface than any place allows: this takes no rays.
  std::optional<std::string> why_position_is_invalid(const glm::vec3& position,
                                                     const Strictness& strictness) const;
  Place place(const glm::vec3& position) const;
  std::optional<std::string> why_place_is_invalid(const Place& place, const Strictness& strictness) const;
  Verdict judge(const Camera& camera, const Place& place, float aspect, const Strictness& strictness) const;

 private:
  double clearance(const Place& place) const;
  std::optional<std::string> why_sight_is_invalid(const Survey& seen, const Place& place,
                                                  const Strictness& strictness) const;
  double most_background(const Place& place) const;
  double near_share(const Survey& seen, const Place& place) const;
  double lit_share(const Camera& camera, float aspect) const;

  const SceneScale& scale_;
  const ClosestHit& closest_hit_;
  bool black_background_;
  NearestSurface surfaces_;
  LightReach lights_;
};

}  // namespace lightbench::views_2
