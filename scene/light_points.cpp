#include "scene/light_points.h"

namespace lightbench {
namespace {

/// Where a point lies along the two edges, 0..1 from the corner at which both start.
std::vector<glm::vec2> quad_points(const glm::ivec2& counts) {
  std::vector<glm::vec2> points;
  for (int j = 0; j < counts.y; ++j)
    for (int i = 0; i < counts.x; ++i)
      points.push_back((glm::vec2(float(i), float(j)) + 0.5f) / glm::vec2(counts));
  return points;
}

/// Each edge in n parts makes n * n equal triangles: those that stand like the whole one, and between them
/// those that stand upside down.
std::vector<glm::vec2> triangle_points(int n) {
  std::vector<glm::vec2> points;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i + j < n; ++i) {
      const glm::vec2 corner{float(i), float(j)};
      points.push_back((corner + 1.0f / 3.0f) / float(n));
      if (i + j + 1 < n) points.push_back((corner + 2.0f / 3.0f) / float(n));
    }
  return points;
}

}  // namespace

std::vector<Light> light_points(const Light& light) {
  if (light.kind != LightKind::area) return {light};
  const bool quad = light.shape == AreaShape::quad;
  const std::vector<glm::vec2> places = quad ? quad_points(light.points) : triangle_points(light.points.x);
  const glm::vec3 corner = quad ? light.position - 0.5f * (light.edge_u + light.edge_v) : light.position;
  std::vector<Light> result;
  for (const glm::vec2& place : places) {
    Light point = light;
    point.kind = LightKind::point;
    point.position = corner + place.x * light.edge_u + place.y * light.edge_v;
    point.power = light.power / float(places.size());
    result.push_back(point);
  }
  return result;
}

std::vector<Light> light_points(const Scene& scene) {
  std::vector<Light> result;
  for (const Light& light : scene.lights)
    for (Light& point : light_points(light)) result.push_back(std::move(point));
  return result;
}

std::size_t light_point_count(const Light& light) {
  if (light.kind != LightKind::area) return 1;
  const int rows = light.shape == AreaShape::quad ? light.points.y : light.points.x;
  return std::size_t(light.points.x) * std::size_t(rows);
}

std::size_t light_point_count(const Scene& scene) {
  std::size_t count = 0;
  for (const Light& light : scene.lights) count += light_point_count(light);
  return count;
}

}  // namespace lightbench
