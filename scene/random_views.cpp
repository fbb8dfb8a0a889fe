#include "scene/random_views.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "scene/nearest_surface.h"
#include "scene/raw_random.h"
#include "scene/view_judge.h"

namespace lightbench {
namespace {

constexpr int kTriesPerView = 3000;

// Valid views of which the most varied one is taken: two bare walls are valid, but show little.
constexpr int kCandidates = 8;

// Sines of the steepest views that are drawn.
constexpr double kSteepestDown = -0.6;
constexpr double kSteepestUp = 0.35;

// Short decimal numbers, coarse enough that the last bit of a sine does not matter.
class Rounding {
 public:
  explicit Rounding(double diagonal) : step_(std::pow(10.0, std::floor(std::log10(1e-4 * diagonal)))) {}
  glm::vec3 operator()(const glm::dvec3& p) const {
    glm::vec3 result;
    for (int k = 0; k < 3; ++k)
      result[k] = float(std::stod(fmt::format("{:.12g}", std::round(p[k] / step_) * step_)));
    return result;
  }

 private:
  double step_;
};

std::size_t random_index(std::size_t count, RawRandom& random) {
  return std::min(std::size_t(random.unit() * double(count)), count - 1);
}

// A corner of some triangle of some entity, or nothing where that entity has none.
std::optional<glm::dvec3> random_vertex(const Scene& scene, RawRandom& random) {
  const Entity& entity = scene.entities[random_index(scene.entities.size(), random)];
  const Mesh& mesh = scene.meshes[std::size_t(entity.mesh)];
  if (mesh.triangles.empty()) return std::nullopt;
  const auto index = random_index(mesh.triangles.size(), random);
  return glm::dvec3(transform_point(entity.transform, mesh.positions[mesh.triangles[index].x]));
}

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

struct Refusals {
  int count = 0;
  std::string example;
};

[[noreturn]] void fail_without_view(const Scene& scene, const std::map<std::string, Refusals>& refusals) {
  const auto most = std::max_element(refusals.begin(), refusals.end(), [](const auto& a, const auto& b) {
    return a.second.count < b.second.count;
  });
  throw Error(fmt::format("no valid view in {} tries; {} times like this: {}", kTriesPerView,
                          most->second.count, most->second.example),
              scene.name);
}

Bounds usable_bounds(const Scene& scene) {
  const Bounds bounds = world_bounds(scene);
  if (bounds.empty() || !(bounds.diagonal() > 0)) throw Error("an empty scene has no views", scene.name);
  return bounds;
}

// "87 % of the picture are background" counts as one reason whatever the number.
std::string without_numbers(std::string reason) {
  reason.erase(std::remove_if(reason.begin(), reason.end(), [](char c) { return c >= '0' && c <= '9'; }),
               reason.end());
  return reason;
}

// The most varied of the first valid candidates.
Camera draw_camera(const Scene& scene, const Bounds& bounds, const ViewJudge& judge,
                   const RandomViewOptions& options, RawRandom& random, const ClosestHit& closest_hit) {
  std::map<std::string, Refusals> refusals;
  Camera best;
  std::size_t best_monotony = 0;
  int found = 0;
  for (int i = 0; i < kTriesPerView && found < kCandidates; ++i) {
    const Camera candidate = random_camera(scene, bounds, options.fov, random, closest_hit);
    const Verdict verdict = judge.judge(candidate, options.aspect);
    if (verdict.reason) {
      Refusals& alike = refusals[without_numbers(*verdict.reason)];
      ++alike.count;
      alike.example = *verdict.reason;
    } else if (++found == 1 || verdict.monotony < best_monotony) {
      best = candidate;
      best_monotony = verdict.monotony;
    }
  }
  if (found == 0) fail_without_view(scene, refusals);
  return best;
}

}  // namespace

std::vector<View> draw_random_views(const Scene& scene, const RandomViewOptions& options,
                                    const ClosestHit& closest_hit) {
  const Bounds bounds = usable_bounds(scene);
  const ViewJudge judge(bounds, closest_hit);
  RawRandom random(options.seed);
  std::vector<View> views;
  for (int i = 1; i <= options.count; ++i)
    views.push_back({fmt::format("random-{}-{:04}", options.seed, i),
                     draw_camera(scene, bounds, judge, options, random, closest_hit)});
  return views;
}

std::optional<std::string> why_view_is_invalid(const Scene& scene, const View& view, float aspect,
                                               const ClosestHit& closest_hit) {
  return ViewJudge(usable_bounds(scene), closest_hit).judge(view.camera, aspect).reason;
}

}  // namespace lightbench
