#include "scene/views/judge_2.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace lightbench::views_2 {
namespace {

// Shares are of rays.
constexpr double kFewestHitsAround = 0.1;  // fewer say nothing about the place
constexpr double kMostBackFacesInView = 0.3;
constexpr double kMostBackground = 0.6;
constexpr double kMostBlackBackground = 0.35;
constexpr double kMostBackgroundFromOutside = 0.85;  // thin objects fill little of any picture
constexpr double kMostNear = 0.15;

// Distances.
constexpr double kClearance = 0.03;         // of the scene's diagonal, and not more than
constexpr double kClearanceInPlace = 0.2;   // of the place's size: rooms of a large house are small
constexpr double kClearanceStanding = 0.6;  // of the eye's height, for what is below who stands
constexpr double kDownwards = -0.5;         // y of directions to what is below
constexpr double kNear = 0.25;              // of the place's size
constexpr double kNearestViewMedian = 0.5;  // of the place's size; less: a wall in the face
constexpr double kFarthestNearTenth = 1.5;  // of the scene's diagonal

// While less of a picture than this is in the light, its quality grows with the light.
constexpr double kWellLit = 0.6;

// Of the rays of a view, one in so many asks for light. Rows have 16, so that columns change from row to row.
constexpr std::size_t kLightStride = 5;

bool inside(const Bounds& b, const glm::vec3& p) {
  return p.x >= b.min.x && p.y >= b.min.y && p.z >= b.min.z && p.x <= b.max.x && p.y <= b.max.y &&
         p.z <= b.max.z;
}

std::string too_near(float distance, float clearance) {
  return fmt::format("something is {:.3g} from the camera, nearer than {:.3g}", distance, clearance);
}

}  // namespace

ViewJudge::ViewJudge(const Scene& scene, const SceneScale& scale, const ClosestHit& closest_hit)
    : scale_(scale),
      closest_hit_(closest_hit),
      black_background_(scene.background.color == glm::vec3(0)),
      surfaces_(scene),
      lights_(scene, closest_hit) {}

Place ViewJudge::place(const glm::vec3& position) const {
  Place place{position, survey(position, sphere_directions(), scale_.diagonal, closest_hit_),
              0.5 * scale_.diagonal};
  if (place.around.hit_share() >= kFewestHitsAround)
    place.size = std::min(place.around.quantile(0.75), place.size);
  return place;
}

double ViewJudge::clearance(const Place& place) const {
  return std::max(scale_.least_clearance,
                  std::min(kClearance * scale_.diagonal, kClearanceInPlace * place.size));
}

std::optional<std::string> ViewJudge::why_position_is_invalid(const glm::vec3& position,
                                                              const Strictness& strictness) const {
  const float least = float(strictness.clearance * scale_.least_clearance);
  const float nearest = surfaces_.distance(position, least);
  if (nearest < least) return too_near(nearest, least);
  return std::nullopt;
}

std::optional<std::string> ViewJudge::why_place_is_invalid(const Place& place,
                                                           const Strictness& strictness) const {
  const Survey& around = place.around;
  if (scale_.fronts_count && around.hit_share() >= kFewestHitsAround &&
      around.back_share() > kMostBackFacesAround)
    return fmt::format("the camera is inside something: {:.0f} % of what surrounds it are back faces",
                       100 * around.back_share());
  const float aside = float(strictness.clearance * clearance(place));
  const float below = std::min(aside, float(kClearanceStanding * scale_.eye_height));
  const float nearest = surfaces_.distance(place.position, aside);
  if (nearest < below) return too_near(nearest, below);
  if (nearest >= aside) return std::nullopt;
  // Only what is below may be as near as this.
  for (const glm::vec3& direction : sphere_directions()) {
    if (double(direction.y) < kDownwards) continue;
    const auto hit = closest_hit_(place.position, direction);
    if (hit && hit->distance < aside) return too_near(hit->distance, aside);
  }
  return std::nullopt;
}

Verdict ViewJudge::judge(const Camera& camera, const Place& place, float aspect,
                         const Strictness& strictness) const {
  const Survey seen = survey(camera.position, view_directions(camera, aspect), scale_.diagonal, closest_hit_);
  if (auto reason = why_sight_is_invalid(seen, place, strictness)) return {std::move(reason)};
  double light = 1;
  if (strictness.fewest_lit > 0 && lights_.has_light()) {
    const double lit = lit_share(camera, aspect);
    if (lit < strictness.fewest_lit)
      return {fmt::format("light reaches only {:.0f} % of what is in sight", 100 * lit)};
    light = 0.4 + 0.6 * std::min(1.0, lit / kWellLit);
  }
  const double variety = 1 - double(seen.monotony) / double(seen.rays * seen.rays);
  return {std::nullopt, variety * light * (1 - near_share(seen, place))};
}

std::optional<std::string> ViewJudge::why_sight_is_invalid(const Survey& seen, const Place& place,
                                                           const Strictness& strictness) const {
  if (1 - seen.hit_share() > most_background(place))
    return fmt::format("{:.0f} % of the picture are background", 100 * (1 - seen.hit_share()));
  if (scale_.fronts_count && seen.back_share() > kMostBackFacesInView)
    return fmt::format("{:.0f} % of the picture are back faces", 100 * seen.back_share());
  if (double(seen.largest_plane) > strictness.most_of_one_plane * double(seen.rays))
    return "a single flat surface fills the picture";
  if (near_share(seen, place) > kMostNear || seen.quantile(0.5) < kNearestViewMedian * place.size)
    return "something close to the camera fills the picture";
  if (seen.quantile(0.1) > kFarthestNearTenth * scale_.diagonal) return "nothing is near enough in sight";
  return std::nullopt;
}

double ViewJudge::most_background(const Place& place) const {
  if (!inside(scale_.bounds, place.position)) return kMostBackgroundFromOutside;
  return black_background_ ? kMostBlackBackground : kMostBackground;
}

double ViewJudge::near_share(const Survey& seen, const Place& place) const {
  const auto far = std::lower_bound(seen.distances.begin(), seen.distances.end(), float(kNear * place.size));
  return double(far - seen.distances.begin()) / double(seen.rays);
}

double ViewJudge::lit_share(const Camera& camera, float aspect) const {
  const auto directions = view_directions(camera, aspect);
  int hits = 0, lit = 0;
  for (std::size_t i = 0; i < directions.size(); i += kLightStride) {
    const auto hit = closest_hit_(camera.position, directions[i]);
    if (!hit) continue;
    ++hits;
    const bool front = glm::dot(hit->normal, directions[i]) < 0;
    lit += lights_.lit(camera.position + hit->distance * directions[i], front ? hit->normal : -hit->normal);
  }
  return hits == 0 ? 0 : double(lit) / hits;
}

}  // namespace lightbench::views_2
