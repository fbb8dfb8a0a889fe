#include "scene/views/judge_1.h"

#include <algorithm>

#include <fmt/format.h>

namespace lightbench::views_1 {
namespace {

// The rules. Shares are of rays, distances are relative to what is around the camera or to the scene's
// diagonal.
constexpr double kMostBackFacesInView = 0.5;
constexpr double kFewestHitsAround = 0.1;  // fewer say nothing about the inside
constexpr double kMostBackground = 0.6;
constexpr double kMostOfOnePlane = 0.85;  // more: a wall fills the picture
// The upper quartile around the camera is the size of the place: beside a wall, half of all rays are short.
constexpr double kClearance = 0.015;         // nearest / upper quartile of the distances around
constexpr double kSmallestClearance = 2e-4;  // nearest distance / diagonal
constexpr double kNearestViewMedian = 0.1;   // median distance in the view / upper quartile around
constexpr double kFarthestNearTenth = 1.5;   // distance that a tenth of the view keeps below / diagonal

}  // namespace

ViewJudge::ViewJudge(const Bounds& bounds, const ClosestHit& closest_hit)
    : diagonal_(bounds.diagonal()),
      closest_hit_(closest_hit),
      fronts_count_(!are_faces_turned_inside_out(bounds, closest_hit)) {}

Verdict ViewJudge::judge(const Camera& camera, float aspect) const {
  const Survey around = survey(camera.position, sphere_directions(), diagonal_, closest_hit_);
  if (auto reason = why_position_is_invalid(around)) return {std::move(reason)};
  const Survey seen = survey(camera.position, view_directions(camera, aspect), diagonal_, closest_hit_);
  return {why_sight_is_invalid(seen, around), seen.monotony};
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

}  // namespace lightbench::views_1
