#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>

#include "scene/random_views.h"
#include "scene/raw_random.h"
#include "scene/scene.h"
#include "scene/views/drawing.h"
#include "scene/views/scene_scale.h"

namespace lightbench::views_2 {

class Stances;

/// A way to choose where a camera stands and how it looks.
struct Stance {
  std::optional<glm::vec3> (Stances::*position)(RawRandom&) const;  ///< nothing: not there, try again
  const char* nowhere;                                              ///< what it means if there is none
  int tries;                                                        ///< for each view
  double quality;                                                   ///< factor on that of its views
  bool is_enough;        ///< whether the stances after it are not tried where it finds some places
  double steepest_down;  ///< sines
  double steepest_up;
};

/// Draws positions and directions in one scene.
class Stances {
 public:
  Stances(const Scene& scene, const SceneScale& scale, float fov, float aspect,
          const ClosestHit& closest_hit);

  /// At the height of eyes over a floor, or in the middle below a low ceiling.
  std::optional<glm::vec3> standing(RawRandom& random) const;
  /// Anywhere in the bounds.
  std::optional<glm::vec3> floating(RawRandom& random) const;
  /// Outside, where the scene about fills the picture.
  std::optional<glm::vec3> outside(RawRandom& random) const;

  /// A camera that looks at some piece of the scene (the first direction) or anywhere, not too steeply; from
  /// outside, at the middle.
  Camera look(const glm::vec3& position, const Stance& stance, int number, RawRandom& random) const;

 private:
  glm::dvec3 point_near_pieces(RawRandom& random) const;
  std::optional<double> ground_below(const glm::vec3& point) const;

  const Scene& scene_;
  const SceneScale& scale_;
  const ClosestHit& closest_hit_;
  Rounding rounded_;
  float fov_;
  double half_angle_;  ///< of the narrower side of the picture
};

inline constexpr Stance kStanding{&Stances::standing, "there is no floor", 800, 1, true, -0.45, 0.15};
inline constexpr Stance kFloating{&Stances::floating, "", 400, 0.6, false, -0.6, 0.3};
inline constexpr Stance kOutside{&Stances::outside, "", 200, 0.8, true, -0.9, 0.3};

/// In the order in which they are tried.
inline constexpr std::array kStancesInPlaces{kStanding, kFloating, kOutside};
inline constexpr std::array kStancesAroundObject{kOutside, kStanding, kFloating};

}  // namespace lightbench::views_2
