#include "scene/water.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace lightbench {
namespace {

double wave_number(const Wave& wave) {
  return glm::two_pi<double>() / double(wave.wavelength);
}

double phase_at(const Wave& wave, const glm::dvec2& place, double time) {
  const double along = glm::dot(glm::dvec2(wave.direction), place) - double(wave.speed) * time;
  return wave_number(wave) * along + double(wave.phase);
}

}  // namespace

double water_level(const Water& water, const glm::dvec2& place, double time) {
  double level = double(water.height);
  for (const Wave& wave : water.waves)
    level += double(wave.amplitude) * std::sin(phase_at(wave, place, time));
  return level;
}

double highest_crest(const Water& water) {
  double level = double(water.height);
  for (const Wave& wave : water.waves) level += std::abs(double(wave.amplitude));
  return level;
}

glm::dvec3 water_normal(const Water& water, const glm::dvec2& place, double time) {
  glm::dvec2 slope(0);
  for (const Wave& wave : water.waves)
    slope += double(wave.amplitude) * wave_number(wave) * std::cos(phase_at(wave, place, time)) *
             glm::dvec2(wave.direction);
  return glm::normalize(glm::dvec3(-slope.x, 1, -slope.y));
}

double focusing_strength(const Water& water, double depth) {
  double curvature = 0;
  for (const Wave& wave : water.waves)
    curvature += double(wave.amplitude) * wave_number(wave) * wave_number(wave);
  return 0.25 * depth * curvature;
}

Mesh water_mesh(const Water& water, double time) {
  Mesh mesh;
  mesh.name = "water";
  const glm::dvec2 low(water.min), size = glm::dvec2(water.max) - low;
  for (int z = 0; z < water.grid.y; ++z)
    for (int x = 0; x < water.grid.x; ++x) {
      const glm::dvec2 place = low + size * glm::dvec2(x, z) / glm::dvec2(water.grid - 1);
      mesh.positions.emplace_back(place.x, water_level(water, place, time), place.y);
      mesh.normals.emplace_back(water_normal(water, place, time));
    }
  for (int z = 0; z + 1 < water.grid.y; ++z)
    for (int x = 0; x + 1 < water.grid.x; ++x) {
      const auto near = std::uint32_t(z * water.grid.x + x), far = near + std::uint32_t(water.grid.x);
      mesh.triangles.emplace_back(near, far, near + 1);
      mesh.triangles.emplace_back(near + 1, far, far + 1);
    }
  mesh.parts = {{0, 0, std::uint32_t(mesh.triangles.size())}};
  return mesh;
}

std::optional<glm::dvec3> refracted(const glm::dvec3& direction, const glm::dvec3& normal, double ratio) {
  const double cos_in = -glm::dot(normal, direction);
  const double cos_out_squared = 1 - ratio * ratio * (1 - cos_in * cos_in);
  if (cos_out_squared < 0) return std::nullopt;
  return glm::normalize((ratio * cos_in - std::sqrt(cos_out_squared)) * normal + ratio * direction);
}

double fresnel_transmission(const glm::dvec3& direction, const glm::dvec3& normal, double ratio) {
  const auto beyond = refracted(direction, normal, ratio);
  if (!beyond) return 0;
  const double in = -glm::dot(normal, direction), out = -glm::dot(normal, *beyond);
  const double across = (ratio * in - out) / (ratio * in + out),
               along = (in - ratio * out) / (in + ratio * out);
  return 1 - 0.5 * (across * across + along * along);
}

}  // namespace lightbench
