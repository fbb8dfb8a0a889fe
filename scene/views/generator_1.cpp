#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "scene/views/drawing.h"
#include "scene/views/generators.h"
#include "scene/views/judge_1.h"

namespace lightbench::views_1 {
namespace {

constexpr int kTriesPerView = 3000;

// Valid views of which the most varied one is taken: two bare walls are valid, but show little.
constexpr int kCandidates = 8;

// Sines of the steepest views that are drawn.
constexpr double kSteepestDown = -0.6;
constexpr double kSteepestUp = 0.35;

// A point of the bounds, drawn towards some piece of the scene (outer scenery makes bounds much larger than
// what there is to see) and towards the floor below it, and a direction that is not too steep.
Camera random_camera(const Scene& scene, const Bounds& bounds, float fov, RawRandom& random,
                     const ClosestHit& closest_hit) {
  const Rounding rounded(bounds.diagonal());
  glm::dvec3 position = random.point(bounds);
  const double distance = random.unit();
  if (const auto piece = random_vertex(scene, random))
    position = glm::mix(*piece, position, distance * distance);
  const double height = random.unit();
  const double yaw = random.between(0, 2 * 3.14159265358979323846);
  const double sine = random.between(kSteepestDown, kSteepestUp);
  if (const auto floor = closest_hit(glm::vec3(position), {0, -1, 0}))
    position.y -= double(floor->distance) * (1 - height * height);
  const double cosine = std::sqrt(1 - sine * sine);
  const glm::dvec3 direction(cosine * std::sin(yaw), sine, cosine * std::cos(yaw));
  Camera camera;
  camera.position = rounded(position);
  camera.look_at = rounded(position + 0.1 * double(bounds.diagonal()) * direction);
  camera.fov = fov;
  return camera;
}

// The most varied of the first valid candidates.
Camera draw_camera(const Scene& scene, const Bounds& bounds, const ViewJudge& judge,
                   const RandomViewOptions& options, RawRandom& random, const ClosestHit& closest_hit) {
  Refusals refusals;
  Camera best;
  std::size_t best_monotony = 0;
  int found = 0;
  for (int i = 0; i < kTriesPerView && found < kCandidates; ++i) {
    const Camera candidate = random_camera(scene, bounds, options.fov, random, closest_hit);
    const Verdict verdict = judge.judge(candidate, options.aspect);
    if (verdict.reason) {
      refusals.add(*verdict.reason);
    } else if (++found == 1 || verdict.monotony < best_monotony) {
      best = candidate;
      best_monotony = verdict.monotony;
    }
  }
  if (found == 0)
    throw Error(fmt::format("no valid view in {} tries; {}", kTriesPerView, refusals.most_frequent()),
                scene.name);
  return best;
}

}  // namespace

std::vector<Camera> draw_cameras(const Scene& scene, const RandomViewOptions& options,
                                 const ClosestHit& closest_hit) {
  const Bounds bounds = world_bounds(scene);
  const ViewJudge judge(bounds, closest_hit);
  RawRandom random(options.seed);
  std::vector<Camera> cameras;
  for (int i = 0; i < options.count; ++i)
    cameras.push_back(draw_camera(scene, bounds, judge, options, random, closest_hit));
  return cameras;
}

std::optional<std::string> why_invalid(const Scene& scene, const Camera& camera, float aspect,
                                       const ClosestHit& closest_hit) {
  return ViewJudge(world_bounds(scene), closest_hit).judge(camera, aspect).reason;
}

}  // namespace lightbench::views_1
