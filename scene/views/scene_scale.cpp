#include "scene/views/scene_scale.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/raw_random.h"
#include "scene/views/drawing.h"
#include "scene/views/ray_survey.h"

namespace lightbench::views_2 {
namespace {

constexpr int kSamples = 200;

// Shares of the samples: fewer ceilings than this are those of boxes in the open; as many places of a room's
// height are no accident.
constexpr double kFewestCeilings = 0.15;
constexpr double kFewestRooms = 0.15;

// In metres: the height of rooms; how large scenes are; eyes of people who stand; the least clearance.
constexpr double kLowestRoom = 1.9, kHighestRoom = 6;
constexpr double kSmallestScene = 3, kLargestScene = 5000;
constexpr double kEyeHeight = 1.6;
constexpr double kLeastClearance = 0.2;
constexpr double kWalkable = 16;

// A place has walls around where so many of the rays that go aside meet a front. A scene is made of such
// places where so many samples are.
constexpr float kAside = 0.5f;
constexpr double kFewestWallHits = 0.7;
constexpr double kFewestPlaces = 0.4;

// Where the unit is not known.
constexpr double kEyeInRoom = 0.6;
constexpr double kEyeInScene = 0.05;

// The height of what is free above and below points of the scene that have a floor and a ceiling, sorted.
std::vector<double> free_heights(const Scene& scene, const SceneScale& scale, const ClosestHit& closest_hit) {
  RawRandom random(1);
  std::vector<double> heights;
  const auto surface = [&](const glm::vec3& point, float y) {
    const glm::vec3 direction(0, y, 0);
    auto hit = closest_hit(point, direction);
    if (hit && scale.fronts_count && glm::dot(hit->normal, direction) > 0) hit.reset();
    return hit;
  };
  for (int i = 0; i < kSamples; ++i) {
    glm::dvec3 point = random.point(scale.bounds);
    const double nearness = random.unit();
    if (const auto piece = random_vertex(scene, random)) point = glm::mix(*piece, point, nearness);
    const auto floor = surface(glm::vec3(point), -1);
    const auto ceiling = surface(glm::vec3(point), 1);
    if (floor && ceiling) heights.push_back(double(floor->distance) + double(ceiling->distance));
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

bool has_walls_around(const glm::vec3& point, const SceneScale& scale, const ClosestHit& closest_hit) {
  int rays = 0, hits = 0;
  for (const glm::vec3& direction : sphere_directions()) {
    if (std::abs(direction.y) > kAside) continue;
    ++rays;
    const auto hit = closest_hit(point, direction);
    if (hit && (!scale.fronts_count || glm::dot(hit->normal, direction) < 0)) ++hits;
  }
  return hits >= kFewestWallHits * rays;
}

double share_with_walls(const SceneScale& scale, const ClosestHit& closest_hit) {
  RawRandom random(2);
  int places = 0;
  for (int i = 0; i < kSamples; ++i)
    places += has_walls_around(glm::vec3(random.point(scale.bounds)), scale, closest_hit);
  return double(places) / kSamples;
}

}  // namespace

SceneScale scene_scale(const Scene& scene, const ClosestHit& closest_hit) {
  SceneScale scale;
  scale.bounds = world_bounds(scene);
  scale.diagonal = double(scale.bounds.diagonal());
  scale.fronts_count = !are_faces_turned_inside_out(scale.bounds, closest_hit);
  const auto heights = free_heights(scene, scale, closest_hit);
  const auto rooms = std::count_if(heights.begin(), heights.end(),
                                   [](double h) { return h >= kLowestRoom && h <= kHighestRoom; });
  const bool has_ceilings = double(heights.size()) >= kFewestCeilings * kSamples;
  const bool metres = has_ceilings ? double(rooms) >= kFewestRooms * kSamples
                                   : scale.diagonal >= kSmallestScene && scale.diagonal <= kLargestScene;
  if (metres)
    scale.least_clearance = kLeastClearance;
  else
    scale.eye_height = has_ceilings ? kEyeInRoom * heights[heights.size() / 2] : kEyeInScene * scale.diagonal;
  scale.is_object = share_with_walls(scale, closest_hit) < kFewestPlaces &&
                    (scale.diagonal < kWalkable || (!metres && !has_ceilings));
  return scale;
}

}  // namespace lightbench::views_2
