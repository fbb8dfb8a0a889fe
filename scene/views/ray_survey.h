#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/random_views.h"
#include "scene/scene.h"

/// Rays by which the generators of random views judge. All versions use them: another number here would
/// change the views that version 1 promises.
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

/// Evenly over the sphere.
const std::vector<glm::vec3>& sphere_directions();

/// Evenly over the picture, row by row.
std::vector<glm::vec3> view_directions(const Camera& camera, float aspect);

/// Traces rays from `position`. Two hits lie in one plane where their normals and their planes' distances,
/// in hundredths of `diagonal`, are about equal.
Survey survey(const glm::vec3& position, const std::vector<glm::vec3>& directions, double diagonal,
              const ClosestHit& closest_hit);

/// Whether nearly all enclosed places of the bounds see back faces only: where all walls are turned inside
/// out, every one of them would look like the inside of a solid, so that fronts mean nothing.
bool are_faces_turned_inside_out(const Bounds& bounds, const ClosestHit& closest_hit);

/// More back faces around than this: inside of something, or behind the scenery.
inline constexpr double kMostBackFacesAround = 0.6;

}  // namespace lightbench
