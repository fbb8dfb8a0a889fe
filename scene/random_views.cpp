#include "scene/random_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.h"

namespace lightbench {
namespace {

constexpr int kTriesPerView = 3000;

// Rays of the checks. Enough that a share of them is right within a few percent.
constexpr int kSphereRays = 96;
constexpr int kColumns = 16;
constexpr int kRows = 12;

// The rules. Shares are of rays, distances are relative to what is around the camera or to the scene's
// diagonal.
constexpr double kMostBackFacesAround = 0.6;  // more: inside of something, or behind the scenery
constexpr double kMostBackFacesInView = 0.4;
constexpr double kFewestHitsAround = 0.1;  // fewer say nothing about the inside
constexpr double kMostBackground = 0.6;
constexpr double kMostOfOnePlane = 0.85;      // more: a wall fills the picture
constexpr double kClearance = 0.02;           // nearest / median distance around
constexpr double kSmallestClearance = 2e-4;   // nearest distance / diagonal
constexpr double kNearestViewMedian = 0.15;   // median distance in the view / around
constexpr double kFarthestNearQuarter = 0.3;  // distance that a quarter of the view keeps below / diagonal

// Sines of the steepest views that are drawn.
constexpr double kSteepestDown = -0.6;
constexpr double kSteepestUp = 0.35;

constexpr double kPi = 3.14159265358979323846;

// What a set of rays met.
struct Survey {
  std::size_t rays = 0;
  std::size_t back_faces = 0;
  std::vector<float> distances;   // of the hits, sorted
  std::size_t largest_plane = 0;  // hits of the plane that most hits lie in

  double hits() const { return double(distances.size()); }
  double hit_share() const { return hits() / double(rays); }
  double back_share() const { return distances.empty() ? 0.0 : double(back_faces) / hits(); }
  double quantile(double q) const { return distances[std::size_t(q * (hits() - 1))]; }
};

// Planes are told apart by their normal and their distance from the camera, both rounded.
using PlaneKey = std::array<int, 4>;

PlaneKey plane_key(const RayHit& hit, const glm::vec3& direction, double scale) {
  const double height = double(hit.distance) * double(glm::dot(hit.normal, direction)) / scale;
  const glm::dvec3 n = 10.0 * glm::dvec3(hit.normal);
  return {int(std::lround(n.x)), int(std::lround(n.y)), int(std::lround(n.z)),
          int(std::lround(200.0 * height))};
}

template <typename Directions>
Survey survey(const glm::vec3& position, const Directions& directions, double scale,
              const ClosestHit& closest_hit) {
  Survey result;
  std::map<PlaneKey, std::size_t> planes;
  for (const glm::vec3& direction : directions) {
    ++result.rays;
    const auto hit = closest_hit(position, direction);
    if (!hit) continue;
    result.distances.push_back(hit->distance);
    if (glm::dot(hit->normal, direction) > 0) ++result.back_faces;
    result.largest_plane = std::max(result.largest_plane, ++planes[plane_key(*hit, direction, scale)]);
  }
  std::sort(result.distances.begin(), result.distances.end());
  return result;
}

// Evenly over the sphere: a Fibonacci lattice.
std::vector<glm::vec3> sphere_directions() {
  const double golden = kPi * (3.0 - std::sqrt(5.0));
  std::vector<glm::vec3> result;
  for (int i = 0; i < kSphereRays; ++i) {
    const double y = 1.0 - 2.0 * (i + 0.5) / kSphereRays;
    const double radius = std::sqrt(1.0 - y * y);
    result.emplace_back(radius * std::cos(golden * i), y, radius * std::sin(golden * i));
  }
  return result;
}

std::vector<glm::vec3> view_directions(const Camera& camera, float aspect) {
  const CameraFrame frame = camera_frame(camera);
  const float tangent = std::tan(0.5f * camera.fov);
  std::vector<glm::vec3> result;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const float x = (2.0f * (float(column) + 0.5f) / kColumns - 1.0f) * aspect * tangent;
      const float y = (1.0f - 2.0f * (float(row) + 0.5f) / kRows) * tangent;
      result.push_back(glm::normalize(frame.forward + x * frame.right + y * frame.up));
    }
  return result;
}

enum class Orientation {
  outward,  ///< faces show their front to the free space
  unknown,  ///< they do not, or not all: fronts and backs say nothing
};

class ViewJudge {
 public:
  ViewJudge(double diagonal, Orientation orientation, const ClosestHit& closest_hit)
      : diagonal_(diagonal), oriented_(orientation == Orientation::outward), closest_hit_(closest_hit) {}

  std::optional<std::string> why_invalid(const Camera& camera, float aspect) const {
    const Survey around = survey(camera.position, sphere_, diagonal_, closest_hit_);
    if (auto reason = why_position_is_invalid(around)) return reason;
    const Survey seen = survey(camera.position, view_directions(camera, aspect), diagonal_, closest_hit_);
    return why_sight_is_invalid(seen, around);
  }

  Survey around(const glm::vec3& position) const {
    return survey(position, sphere_, diagonal_, closest_hit_);
  }

 private:
  std::optional<std::string> why_position_is_invalid(const Survey& around) const {
    if (around.hit_share() < kFewestHitsAround) return std::nullopt;
    if (oriented_ && around.back_share() > kMostBackFacesAround)
      return fmt::format("the camera is inside something: {:.0f} % of what surrounds it are back faces",
                         100 * around.back_share());
    const double clearance = std::max(kClearance * around.quantile(0.5), kSmallestClearance * diagonal_);
    if (around.distances.front() < clearance)
      return fmt::format("something is {:.3g} from the camera, nearer than {:.3g}", around.distances.front(),
                         clearance);
    return std::nullopt;
  }

  std::optional<std::string> why_sight_is_invalid(const Survey& seen, const Survey& around) const {
    if (1 - seen.hit_share() > kMostBackground)
      return fmt::format("{:.0f} % of the picture are background", 100 * (1 - seen.hit_share()));
    if (oriented_ && seen.back_share() > kMostBackFacesInView)
      return fmt::format("{:.0f} % of the picture are back faces", 100 * seen.back_share());
    if (double(seen.largest_plane) > kMostOfOnePlane * double(seen.rays))
      return "a single flat surface fills the picture";
    if (around.hit_share() >= kFewestHitsAround &&
        seen.quantile(0.5) < kNearestViewMedian * around.quantile(0.5))
      return "something close to the camera fills the picture";
    if (seen.quantile(0.25) > kFarthestNearQuarter * diagonal_) return "nothing is near enough in sight";
    return std::nullopt;
  }

  double diagonal_;
  bool oriented_;
  const ClosestHit& closest_hit_;
  const std::vector<glm::vec3> sphere_ = sphere_directions();
};

// Equal on every platform, unlike the standard distributions.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}
  double unit() { return double(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::mt19937_64 engine_;
};

glm::dvec3 random_point(const Bounds& bounds, RandomNumbers& random) {
  glm::dvec3 p;
  for (int k = 0; k < 3; ++k) p[k] = random.between(bounds.min[k], bounds.max[k]);
  return p;
}

// Where all walls are turned inside out, every place that is enclosed looks like the inside of a solid.
Orientation orientation_of(const Bounds& bounds, const ClosestHit& closest_hit) {
  constexpr int kSamples = 200;
  const ViewJudge judge(bounds.diagonal(), Orientation::outward, closest_hit);
  RandomNumbers random(1);
  int enclosed = 0;
  int behind = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Survey around = judge.around(glm::vec3(random_point(bounds, random)));
    if (around.hit_share() < 0.5) continue;
    ++enclosed;
    if (around.back_share() > kMostBackFacesAround) ++behind;
  }
  return enclosed > kSamples / 10 && behind > 0.95 * enclosed ? Orientation::unknown : Orientation::outward;
}

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

// A point of the bounds, drawn towards the floor below it, and a direction that is not too steep.
Camera random_camera(const Bounds& bounds, float fov, RandomNumbers& random, const ClosestHit& closest_hit) {
  const Rounding rounded(bounds.diagonal());
  glm::dvec3 position = random_point(bounds, random);
  const double height = random.unit();
  const double yaw = random.between(0, 2 * kPi);
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

[[noreturn]] void fail_without_view(const Scene& scene, int found,
                                    const std::map<std::string, int>& reasons) {
  std::string most = "none";
  int count = 0;
  for (const auto& [reason, n] : reasons)
    if (n > count) {
      most = reason;
      count = n;
    }
  throw Error(fmt::format("no valid view in {} tries after {} views; {} times: {}", kTriesPerView, found,
                          count, most),
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

}  // namespace

std::vector<View> draw_random_views(const Scene& scene, const RandomViewOptions& options,
                                    const ClosestHit& closest_hit) {
  const Bounds bounds = usable_bounds(scene);
  const ViewJudge judge(bounds.diagonal(), orientation_of(bounds, closest_hit), closest_hit);
  RandomNumbers random(options.seed);
  std::vector<View> views;
  while (int(views.size()) < options.count) {
    std::map<std::string, int> reasons;
    std::optional<Camera> camera;
    for (int i = 0; i < kTriesPerView && !camera; ++i) {
      const Camera candidate = random_camera(bounds, options.fov, random, closest_hit);
      const auto reason = judge.why_invalid(candidate, options.aspect);
      if (reason)
        ++reasons[without_numbers(*reason)];
      else
        camera = candidate;
    }
    if (!camera) fail_without_view(scene, int(views.size()), reasons);
    views.push_back({fmt::format("random-{}-{:04}", options.seed, views.size() + 1), *camera});
  }
  return views;
}

std::optional<std::string> why_view_is_invalid(const Scene& scene, const View& view, float aspect,
                                               const ClosestHit& closest_hit) {
  const Bounds bounds = usable_bounds(scene);
  return ViewJudge(bounds.diagonal(), orientation_of(bounds, closest_hit), closest_hit)
      .why_invalid(view.camera, aspect);
}

}  // namespace lightbench
