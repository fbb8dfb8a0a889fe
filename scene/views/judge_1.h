#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "scene/random_views.h"
#include "scene/scene.h"
#include "scene/views/ray_survey.h"

/// The rules of version 1. They stay as they are: FORMAT.md promises the same views for the same seed.
namespace lightbench::views_1 {

struct Verdict {
  std::optional<std::string> reason;  ///< why the view is not valid, or nothing
  std::size_t monotony = 0;           ///< of the picture, where it is valid
};

/// Judges views of one scene by rays. All distances are relative to the scene or to what is around the
/// camera.
class ViewJudge {
 public:
  /// First finds out, by rays too, whether the scene's faces have a front that means something.
  ViewJudge(const Bounds& bounds, const ClosestHit& closest_hit);

  Verdict judge(const Camera& camera, float aspect) const;

 private:
  std::optional<std::string> why_position_is_invalid(const Survey& around) const;
  std::optional<std::string> why_sight_is_invalid(const Survey& seen, const Survey& around) const;

  double diagonal_;
  const ClosestHit& closest_hit_;
  bool fronts_count_;
};

}  // namespace lightbench::views_1
