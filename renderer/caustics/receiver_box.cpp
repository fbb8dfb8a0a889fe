#include "renderer/caustics/receiver_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "renderer/caustics/water_light.h"

namespace lightbench {
namespace {

constexpr double kMargin = 1e-4;  // of the largest side

}  // namespace

glm::dvec3 ReceiverBox::direction_to_map(const glm::dvec3& direction) const {
  return {glm::dot(u, direction) / size.x, glm::dot(w, direction) / size.z, -glm::dot(v, direction) / size.y};
}

glm::dvec3 ReceiverBox::to_map(const glm::dvec3& point) const {
  return 0.5 + direction_to_map(point - center);
}

glm::dvec3 ReceiverBox::from_map(const glm::dvec3& place) const {
  const glm::dvec3 p = place - 0.5;
  return center + p.x * size.x * u + p.y * size.z * w - p.z * size.y * v;
}

ReceiverBox receiver_box(const Scene& scene, std::size_t entity, const glm::dvec3& axis) {
  ReceiverBox box;
  box.v = -axis;
  const glm::dvec3 aside = std::abs(box.v.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  box.w = glm::normalize(glm::cross(aside, box.v));
  box.u = glm::cross(box.v, box.w);
  const Entity& placed = scene.entities[entity];
  glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
  for (const glm::vec3& position : scene.meshes[std::size_t(placed.mesh)].positions) {
    const glm::dvec3 p(glm::vec3(placed.transform * glm::vec4(position, 1)));
    const glm::dvec3 local(glm::dot(box.u, p), glm::dot(box.v, p), glm::dot(box.w, p));
    low = glm::min(low, local);
    high = glm::max(high, local);
  }
  const glm::dvec3 middle = 0.5 * (low + high), extent = high - low;
  box.center = middle.x * box.u + middle.y * box.v + middle.z * box.w;
  box.size = extent + 2 * kMargin * std::max({extent.x, extent.y, extent.z});
  return box;
}

ReceiverBox receiver_box(const Scene& scene, std::size_t entity, const Light& light) {
  const glm::dvec3 center(entity_bounds(scene, entity).center());
  return receiver_box(scene, entity, flat_water_axis(*scene.water, light, center));
}

}  // namespace lightbench
