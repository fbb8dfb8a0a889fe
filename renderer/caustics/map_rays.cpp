#include "renderer/caustics/map_rays.h"

#include <array>

#include <glm/common.hpp>

namespace lightbench {
namespace {

/// Along a ray, by depth z in the box.
struct MapRay {
  glm::dvec2 place{0}, place_step{0};
  double way = 0, way_step = 0;
  bool runs_down = false;
};

MapRay map_ray(const ReceiverBox& box, const glm::dvec3& origin, const glm::dvec3& direction) {
  const glm::dvec3 start = box.to_map(origin), step = box.direction_to_map(direction);
  MapRay ray;
  // The axis is the way of light below flat water: waves turn it by less than this, or its image is all
  // noise.
  constexpr double kLeastCosine = 0.05;
  ray.runs_down = step.z * box.size.y > kLeastCosine;
  if (!ray.runs_down) return ray;
  ray.way_step = 1 / step.z;
  ray.way = -start.z * ray.way_step;
  ray.place_step = glm::dvec2(step) * ray.way_step;
  ray.place = glm::dvec2(start) + glm::dvec2(step) * ray.way;
  return ray;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

using Volume = std::array<MapRay, 3>;

/// Of the corners' images as functions of z.
glm::dvec3 area(const Volume& volume) {
  const glm::dvec2 a = volume[1].place - volume[0].place, b = volume[2].place - volume[0].place;
  const glm::dvec2 a_step = volume[1].place_step - volume[0].place_step,
                   b_step = volume[2].place_step - volume[0].place_step;
  return 0.5 * glm::dvec3(cross(a, b), cross(a, b_step) + cross(a_step, b), cross(a_step, b_step));
}

/// Corners move along straight lines, so that their bounds at both ends hold all between.
bool may_reach(const Volume& volume) {
  glm::dvec2 low(volume[0].place), high(low);
  double farthest = 0;
  for (const MapRay& ray : volume) {
    for (const glm::dvec2& place : {ray.place, ray.place + ray.place_step}) {
      low = glm::min(low, place);
      high = glm::max(high, place);
    }
    farthest = glm::max(farthest, ray.way + ray.way_step);
  }
  return farthest > 0 && low.x <= 1 && low.y <= 1 && high.x >= 0 && high.y >= 0;
}

}  // namespace

MapRays map_rays(const Mesh& water, const WaterLight& light, const ReceiverBox& box, VolumeCulling culling) {
  MapRays result;
  result.spots = light.spots;
  std::vector<MapRay> rays;
  for (std::size_t i = 0; i < water.positions.size(); ++i) {
    const MapRay ray = map_ray(box, glm::dvec3(water.positions[i]), glm::dvec3(light.directions[i]));
    rays.push_back(ray);
    result.places.emplace_back(ray.place, ray.place_step);
    result.ways.emplace_back(ray.way, ray.way_step);
  }
  const double map_area = box.size.x * box.size.z;
  for (std::size_t i = 0; i < water.triangles.size(); ++i) {
    const glm::vec3& flux = light.flux[i];
    if (flux == glm::vec3(0)) continue;
    ++result.lit;
    const glm::uvec3& corners = water.triangles[i];
    const Volume volume{rays[corners.x], rays[corners.y], rays[corners.z]};
    if (!volume[0].runs_down || !volume[1].runs_down || !volume[2].runs_down) {
      ++result.sideways;
      continue;
    }
    if (culling == VolumeCulling::on && !may_reach(volume)) continue;
    result.corners.push_back(corners);
    for (const MapRay& ray : volume)
      result.most_step = glm::max(result.most_step, glm::abs(glm::vec2(ray.place_step)));
    result.triangles.push_back({glm::vec4(flux, 0), glm::vec4(map_area * area(volume), 0)});
  }
  return result;
}

}  // namespace lightbench
