#include "renderer/caustics/water_light.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "scene/water.h"

namespace lightbench {

Incidence incidence_at(const Light& light, const glm::dvec3& point) {
  const glm::dvec3 color = glm::dvec3(light.color) * double(light.power);
  if (light.kind == LightKind::directional) return {glm::dvec3(light.direction), color};
  const glm::dvec3 way = point - glm::dvec3(light.position);
  const double distance = glm::length(way);
  return {way / distance, color * double(attenuation_factor(light.attenuation, float(distance)))};
}

WaterLight water_light(const Water& water, const Mesh& mesh, const Light& light, bool fresnel) {
  const double ratio = 1 / double(water.ior);
  WaterLight result;
  std::vector<double> passes;  // of each vertex
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3 place(mesh.positions[i]), direction = incidence_at(light, place).direction;
    const glm::dvec3 normal(mesh.normals[i]);
    const glm::dvec3 on_level = place + (double(water.height) - place.y) / direction.y * direction;
    result.spots.emplace_back((glm::dvec2(on_level.x, on_level.z) - glm::dvec2(water.min)) /
                              (glm::dvec2(water.max) - glm::dvec2(water.min)));
    // Where a wave's far side sees no light its triangles have no flux; any direction will do.
    const bool lit = glm::dot(direction, normal) < 0;
    result.directions.emplace_back(lit ? *refracted(direction, normal, ratio) : -normal);
    passes.push_back(fresnel ? (lit ? fresnel_transmission(direction, normal, ratio) : 0) : 1);
  }
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const Incidence incidence = incidence_at(light, (a + b + c) / 3.0);
    const double area = -0.5 * glm::dot(glm::cross(b - a, c - a), incidence.direction);
    const double share = (passes[t.x] + passes[t.y] + passes[t.z]) / 3;
    result.flux.emplace_back(incidence.irradiance * (std::max(area, 0.0) * share));
  }
  return result;
}

glm::dvec3 flat_water_axis(const Water& water, const Light& light, const glm::dvec3& target) {
  const glm::dvec3 direction = incidence_at(light, target).direction;
  return *refracted(direction, {0, 1, 0}, 1 / double(water.ior));
}

std::string water_light_problem(const Scene& scene, const Light& light) {
  const Water& water = *scene.water;
  if (light.kind != LightKind::directional && light.kind != LightKind::point)
    return fmt::format("light '{}' is neither directional nor a point", light.name);
  if (light.kind == LightKind::directional && light.direction.y >= 0)
    return fmt::format("light '{}' does not shine down on the water", light.name);
  if (light.kind == LightKind::point && double(light.position.y) <= highest_crest(water))
    return fmt::format("light '{}' is not above the water", light.name);
  return {};
}

}  // namespace lightbench
