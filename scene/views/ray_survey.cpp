#include "scene/views/ray_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "scene/raw_random.h"

namespace lightbench {
namespace {

// Enough rays that a share of them is right within a few percent.
constexpr int kSphereRays = 96;
constexpr int kColumns = 16;
constexpr int kRows = 12;

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
std::vector<glm::vec3> fibonacci_lattice() {
  const double golden = kPi * (3.0 - std::sqrt(5.0));
  std::vector<glm::vec3> result;
  for (int i = 0; i < kSphereRays; ++i) {
    const double y = 1.0 - 2.0 * (i + 0.5) / kSphereRays;
    const double radius = std::sqrt(1.0 - y * y);
    result.emplace_back(radius * std::cos(golden * i), y, radius * std::sin(golden * i));
  }
  return result;
}

}  // namespace

const std::vector<glm::vec3>& sphere_directions() {
  static const std::vector<glm::vec3> directions = fibonacci_lattice();
  return directions;
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

Survey survey(const glm::vec3& position, const std::vector<glm::vec3>& directions, double diagonal,
              const ClosestHit& closest_hit) {
  Survey result;
  std::map<PlaneKey, std::size_t> planes;
  for (const glm::vec3& direction : directions) {
    ++result.rays;
    const auto hit = closest_hit(position, direction);
    if (!hit) continue;
    result.distances.push_back(hit->distance);
    if (glm::dot(hit->normal, direction) > 0) ++result.back_faces;
    ++planes[plane_key(*hit, direction, diagonal)];
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

bool are_faces_turned_inside_out(const Bounds& bounds, const ClosestHit& closest_hit) {
  constexpr int kSamples = 200;
  RawRandom random(1);
  int enclosed = 0;
  int behind = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Survey around =
        survey(glm::vec3(random.point(bounds)), sphere_directions(), bounds.diagonal(), closest_hit);
    if (around.hit_share() < 0.5) continue;
    ++enclosed;
    if (around.back_share() > kMostBackFacesAround) ++behind;
  }
  return enclosed > kSamples / 10 && behind > 0.95 * enclosed;
}

}  // namespace lightbench
