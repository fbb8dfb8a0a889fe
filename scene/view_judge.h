#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/random_views.h"
#include "scene/scene.h"

namespace lightbench {

/// What a set of rays from one point met.
struct Survey {
  std::size_t rays = 0;
  std::size_t back_faces = 0;
  std::vector<float> distances;   ///< of the hits, sorted
  std::size_t largest_plane = 0;  ///< hits of the plane that most hits lie in
  std::size_t monotony = 0;  ///< sum of the squared ray counts of planes and background; less is more varied

  double hits() const { return double(distances.size()); }
  double hit_share() const { return hits() / double(rays); }
  double back_share() const { return distances.empty() ? 0.0 : double(back_faces) / hits(); }
  double quantile(double q) const { return distances[std::size_t(q * (hits() - 1))]; }
};

struct Verdict {
  std::optional<std::string> reason;  ///< why the view is not valid, or nothing
  std::size_t monotony = 0;           ///< of the picture, where it is valid
};

/// Judges views of one scene by rays. All distances are relative to the scene or to what is around the
/// camera.
class ViewJudge {
 public:
  /// First finds out, by rays too, whether the scene's faces have a front that means something: where all
  /// walls are turned inside out, every enclosed place would look like the inside of a solid.
  ViewJudge(const Bounds& bounds, const ClosestHit& closest_hit);

  Verdict judge(const Camera& camera, float aspect) const;

 private:
  bool are_faces_turned_inside_out(const Bounds& bounds) const;
  std::optional<std::string> why_position_is_invalid(const Survey& around) const;
  std::optional<std::string> why_sight_is_invalid(const Survey& seen, const Survey& around) const;
  Survey survey(const glm::vec3& position, const std::vector<glm::vec3>& directions) const;

  double diagonal_;
  const ClosestHit& closest_hit_;
  std::vector<glm::vec3> sphere_;
  bool fronts_count_;
};

}  // namespace lightbench
