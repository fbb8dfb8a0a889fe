#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

/// What comes through the water's surface.
namespace lightbench {

/// Light at a point of the water.
struct Incidence {
  glm::dvec3 direction;   ///< unit, the way it travels
  glm::dvec3 irradiance;  ///< of a surface that faces it, as Light counts: the radiance of a white one
};

/// Of a directional or a point light.
Incidence incidence_at(const Light& light, const glm::dvec3& point);

/// What a light sends through a water's mesh.
struct WaterLight {
  std::vector<glm::vec3> directions;  ///< of each vertex: the refracted ray, unit
  std::vector<glm::vec3> flux;        ///< of each triangle, as it enters the water: irradiance times area
  /// Of each vertex: where the light's ray to it passes the water's level, 0..1 over its rectangle.
  std::vector<glm::vec2> spots;
};

/// With the vertices' own normals, and the triangles' true areas (the water caustics thesis, eq. 2-8 and
/// 4-18). `fresnel`: only what is not reflected. Triangles that face away from the light have no flux.
WaterLight water_light(const Water& water, const Mesh& mesh, const Light& light, bool fresnel);

/// The way the light takes below flat water, unit, where it goes towards `target` above it.
glm::dvec3 flat_water_axis(const Water& water, const Light& light, const glm::dvec3& target);

/// Why a light cannot shine through the water; empty where it can.
std::string water_light_problem(const Scene& scene, const Light& light);

}  // namespace lightbench
