#include "scene/view_judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "scene/raw_random.h"

namespace lightbench {
namespace {

// Rays of the checks. Enough that a share of them is right within a few percent.
constexpr int kSphereRays = 96;
constexpr int kColumns = 16;
constexpr int kRows = 12;

// The rules. Shares are of rays, distances are relative to what is around the camera or to the scene's
// diagonal.
constexpr double kMostBackFacesAround = 0.6;  // more: inside of something, or behind the scenery
constexpr double kMostBackFacesInView = 0.5;
constexpr double kFewestHitsAround = 0.1;  // fewer say nothing about the inside
constexpr double kMostBackground = 0.6;
constexpr double kMostOfOnePlane = 0.85;  // more: a wall fills the picture
// The upper quartile around the camera is the size of the place: beside a wall, half of all rays are short.
constexpr double kClearance = 0.015;         // nearest / upper quartile of the distances around
constexpr double kSmallestClearance = 2e-4;  // nearest distance / diagonal
constexpr double kNearestViewMedian = 0.1;   // median distance in the view / upper quartile around
constexpr double kFarthestNearTenth = 1.5;   // distance that a tenth of the view keeps below / diagonal

constexpr double kPi = 3.14159265358979323846;

// Planes are told apart by their normal and their distance from the camera, both rounded.
using PlaneKey = std::array<int, 4>;

PlaneKey plane_key(const RayHit& hit, const glm::vec3& direction, double scale) {
  const double height = double(hit.distance) * double(glm::dot(hit.normal, direction)) / scale;
  const glm::dvec3 n = 10.0 * glm::dvec3(hit.normal);
  return {int(std::lround(n.x)), int(std::lround(n.y)), int(std::lround(n.z)),
          int(std::lround(200.0 * height))};
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

}  // namespace

ViewJudge::ViewJudge(const Bounds& bounds, const ClosestHit& closest_hit)
    : diagonal_(bounds.diagonal()),
      closest_hit_(closest_hit),
      sphere_(sphere_directions()),
      fronts_count_(!are_faces_turned_inside_out(bounds)) {}

Verdict ViewJudge::judge(const Camera& camera, float aspect) const {
  const Survey around = survey(camera.position, sphere_);
  if (auto reason = why_position_is_invalid(around)) return {std::move(reason)};
  const Survey seen = survey(camera.position, view_directions(camera, aspect));
  return {why_sight_is_invalid(seen, around), seen.monotony};
}

bool ViewJudge::are_faces_turned_inside_out(const Bounds& bounds) const {
  constexpr int kSamples = 200;
  RawRandom random(1);
  int enclosed = 0;
  int behind = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Survey around = survey(glm::vec3(random.point(bounds)), sphere_);
    if (around.hit_share() < 0.5) continue;
    ++enclosed;
    if (around.back_share() > kMostBackFacesAround) ++behind;
  }
  return enclosed > kSamples / 10 && behind > 0.95 * enclosed;
}

std::optional<std::string> ViewJudge::why_position_is_invalid(const Survey& around) const {
  if (around.hit_share() < kFewestHitsAround) return std::nullopt;
  if (fronts_count_ && around.back_share() > kMostBackFacesAround)
    return fmt::format("the camera is inside something: {:.0f} % of what surrounds it are back faces",
                       100 * around.back_share());
  const double clearance = std::max(kClearance * around.quantile(0.75), kSmallestClearance * diagonal_);
  if (around.distances.front() < clearance)
    return fmt::format("something is {:.3g} from the camera, nearer than {:.3g}", around.distances.front(),
                       clearance);
  return std::nullopt;
}

std::optional<std::string> ViewJudge::why_sight_is_invalid(const Survey& seen, const Survey& around) const {
  if (1 - seen.hit_share() > kMostBackground)
    return fmt::format("{:.0f} % of the picture are background", 100 * (1 - seen.hit_share()));
  if (fronts_count_ && seen.back_share() > kMostBackFacesInView)
    return fmt::format("{:.0f} % of the picture are back faces", 100 * seen.back_share());
  if (double(seen.largest_plane) > kMostOfOnePlane * double(seen.rays))
    return "a single flat surface fills the picture";
  if (around.hit_share() >= kFewestHitsAround &&
      seen.quantile(0.5) < kNearestViewMedian * around.quantile(0.75))
    return "something close to the camera fills the picture";
  if (seen.quantile(0.1) > kFarthestNearTenth * diagonal_) return "nothing is near enough in sight";
  return std::nullopt;
}

Survey ViewJudge::survey(const glm::vec3& position, const std::vector<glm::vec3>& directions) const {
  Survey result;
  std::map<PlaneKey, std::size_t> planes;
  for (const glm::vec3& direction : directions) {
    ++result.rays;
    const auto hit = closest_hit_(position, direction);
    if (!hit) continue;
    result.distances.push_back(hit->distance);
    if (glm::dot(hit->normal, direction) > 0) ++result.back_faces;
    ++planes[plane_key(*hit, direction, diagonal_)];
  }
  const std::size_t missed = result.rays - result.distances.size();
  result.monotony = missed * missed;
  for (const auto& [key, count] : planes) {
    result.largest_plane = std::max(result.largest_plane, count);
    result.monotony += count * count;
  }
  std::sort(result.distances.begin(), result.distances.end());
  return result;
}

}  // namespace lightbench
