#include "scene/views/stances.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/views/ray_survey.h"

namespace lightbench::views_2 {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Below a ceiling, eyes are at most so far up.
constexpr double kHighestEye = 0.6;

// Rays down that must meet something, where there is a floor to stand on. Its height is a low one of theirs:
// a table is no floor.
constexpr int kGroundRays = 12;
constexpr int kFewestGroundHits = 9;
constexpr int kGroundRank = 3;

glm::dvec3 direction(double yaw, double sine) {
  const double cosine = std::sqrt(1 - sine * sine);
  return {cosine * std::sin(yaw), sine, cosine * std::cos(yaw)};
}

double random_yaw(RawRandom& random) {
  return random.between(0, 2 * kPi);
}

}  // namespace

Stances::Stances(const Scene& scene, const SceneScale& scale, float fov, float aspect,
                 const ClosestHit& closest_hit)
    : scene_(scene),
      scale_(scale),
      closest_hit_(closest_hit),
      rounded_(scale.diagonal),
      fov_(fov),
      half_angle_(std::atan(std::tan(0.5 * double(fov)) * std::min(1.0, double(aspect)))) {}

// Half of the points lie anywhere; the others near some piece, since outer scenery makes bounds much larger
// than what there is to see.
glm::dvec3 Stances::point_near_pieces(RawRandom& random) const {
  const glm::dvec3 point = random.point(scale_.bounds);
  const double nearness = random.unit();
  const bool anywhere = random.unit() < 0.5;
  const auto piece = random_vertex(scene_, random);
  return anywhere || !piece ? point : glm::mix(*piece, point, nearness * nearness);
}

std::optional<double> Stances::ground_below(const glm::vec3& point) const {
  std::vector<double> heights;
  for (int i = 0; i < kGroundRays; ++i) {
    const glm::vec3 down(direction(2 * kPi * i / kGroundRays, i % 3 == 0 ? -0.94 : -0.7));
    const auto hit = closest_hit_(point, down);
    if (!hit || (scale_.fronts_count && glm::dot(hit->normal, down) > 0)) continue;
    heights.push_back(double(point.y + hit->distance * down.y));
  }
  if (int(heights.size()) < kFewestGroundHits) return std::nullopt;
  std::sort(heights.begin(), heights.end());
  return heights[kGroundRank];
}

std::optional<glm::vec3> Stances::standing(RawRandom& random) const {
  glm::dvec3 point = point_near_pieces(random);
  const auto ground = ground_below(glm::vec3(point));
  if (!ground) return std::nullopt;
  double eye = scale_.eye_height;
  if (const auto ceiling = closest_hit_(glm::vec3(point), {0, 1, 0}))
    eye = std::min(eye, kHighestEye * (point.y + double(ceiling->distance) - *ground));
  const auto below = closest_hit_(glm::vec3(point), {0, -1, 0});
  if (!below || point.y - double(below->distance) >= *ground + eye) return std::nullopt;
  point.y = *ground + eye;
  return rounded_(point);
}

std::optional<glm::vec3> Stances::floating(RawRandom& random) const {
  return rounded_(point_near_pieces(random));
}

std::optional<glm::vec3> Stances::outside(RawRandom& random) const {
  const double radius = 0.5 * scale_.diagonal;
  const double distance = radius / std::sin(half_angle_) * random.between(0.75, 1.1);
  const double yaw = random_yaw(random);
  const double sine = random.between(-0.1, 0.7);
  return rounded_(glm::dvec3(scale_.bounds.center()) + distance * direction(yaw, sine));
}

Camera Stances::look(const glm::vec3& position, const Stance& stance, int number, RawRandom& random) const {
  const double yaw = random_yaw(random);
  const double sine = random.between(stance.steepest_down, stance.steepest_up);
  glm::dvec3 ahead = direction(yaw, sine);
  std::optional<glm::dvec3> target;
  if (stance.position == &Stances::outside)
    target = glm::dvec3(scale_.bounds.center());
  else if (number == 0)
    target = random_vertex(scene_, random);
  if (target) {
    const glm::dvec3 way = *target - glm::dvec3(position);
    const double flat = std::hypot(way.x, way.z);
    const double tilt = std::clamp(way.y / std::hypot(flat, way.y), stance.steepest_down, stance.steepest_up);
    if (flat > 0)
      ahead = std::sqrt(1 - tilt * tilt) * glm::dvec3(way.x / flat, 0, way.z / flat) + glm::dvec3(0, tilt, 0);
  }
  Camera camera;
  camera.position = position;
  camera.look_at = rounded_(glm::dvec3(position) + 0.1 * scale_.diagonal * ahead);
  camera.fov = fov_;
  return camera;
}

}  // namespace lightbench::views_2
