#include "scene/views/light_reach.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/nearest_surface.h"

namespace lightbench {
namespace {

// The radiance from which on a white surface counts as lit: 39 of 255 in sRGB.
constexpr float kDimmest = 0.02f;

// The strongest lights at a point get a shadow ray each.
constexpr std::size_t kMostShadowRays = 4;

// A ray that comes this near to the light has reached it: an emitter's own surface must not hide it.
constexpr float kReached = 0.999f;

constexpr std::size_t kMostEmitters = 64;

float brightness(const glm::vec3& color) {
  return std::max({color.x, color.y, color.z});
}

// An area light as a point in its middle.
Light without_extent(Light light) {
  if (light.kind != LightKind::area) return light;
  light.kind = LightKind::point;
  if (light.shape == AreaShape::triangle) light.position += (light.edge_u + light.edge_v) / 3.0f;
  return light;
}

// What a small emitting triangle of radiance L and area A sends to a white surface that faces it squarely is
// L A / (pi d^2).
Light emitter(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& radiance) {
  Light light;
  light.position = (a + b + c) / 3.0f;
  light.color = radiance;
  light.power = 0.5f * glm::length(glm::cross(b - a, c - a)) / 3.14159265f;
  light.attenuation.kind = Attenuation::Kind::inverse_square;
  return light;
}

float strength(const Light& light) {
  return brightness(light.color) * light.power;
}

// So many are kept while they are collected, however many triangles emit.
constexpr std::size_t kMostKept = 4096;

void keep_strongest(std::vector<Light>& lights) {
  std::ranges::stable_sort(lights, std::greater(), strength);
  if (lights.size() > kMostEmitters) lights.resize(kMostEmitters);
}

// The strongest of the triangles that emit.
std::vector<Light> emitters(const Scene& scene) {
  std::vector<Light> result;
  for (const Entity& entity : scene.entities) {
    const Mesh& mesh = scene.meshes[std::size_t(entity.mesh)];
    const auto corner = [&](std::uint32_t i) { return transform_point(entity.transform, mesh.positions[i]); };
    for (const MeshPart& part : mesh.parts) {
      const glm::vec3& emission = scene.materials[std::size_t(part.material)].emission;
      if (!(brightness(emission) > 0)) continue;
      for (std::uint32_t i = part.first_triangle; i < part.first_triangle + part.triangle_count; ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        result.push_back(emitter(corner(t.x), corner(t.y), corner(t.z), emission));
        if (result.size() == kMostKept) keep_strongest(result);
      }
    }
  }
  keep_strongest(result);
  return result;
}

float cone_factor(const Light& light, const glm::vec3& to_light) {
  if (light.kind != LightKind::spot) return 1;
  const float cosine = glm::dot(-to_light, light.direction);
  return glm::smoothstep(std::cos(light.outer_angle), std::cos(light.inner_angle) + 1e-6f, cosine);
}

}  // namespace

LightReach::LightReach(const Scene& scene, const ClosestHit& closest_hit)
    : closest_hit_(closest_hit), offset_(1e-5f * world_bounds(scene).diagonal()) {
  for (const Light& light : scene.lights)
    if (strength(light) > 0) lights_.push_back(without_extent(light));
  if (lights_.empty()) lights_ = emitters(scene);
  sky_ = lights_.empty() && scene.background.lights && brightness(scene.background.color) >= kDimmest;
}

LightReach::Ray LightReach::ray_to(const Light& light, const glm::vec3& point,
                                   const glm::vec3& normal) const {
  Ray ray{-light.direction, std::numeric_limits<float>::infinity(), strength(light)};
  if (light.kind != LightKind::directional) {
    ray.distance = glm::distance(point, light.position);
    if (!(ray.distance > 0)) return {normal, 0, 0};
    ray.direction = (light.position - point) / ray.distance;
    ray.radiance *= attenuation_factor(light.attenuation, ray.distance) * cone_factor(light, ray.direction);
  }
  ray.radiance *= std::max(0.0f, glm::dot(normal, ray.direction));
  return ray;
}

bool LightReach::reached(const Ray& ray, const glm::vec3& point, const glm::vec3& normal) const {
  const auto hit = closest_hit_(point + offset_ * normal, ray.direction);
  return !hit || hit->distance >= kReached * ray.distance;
}

// A few directions about the normal are enough: a place that sees the sky in none of them is dim.
bool LightReach::sees_sky(const glm::vec3& point, const glm::vec3& normal) const {
  const glm::vec3 side = std::abs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 tangent = glm::normalize(glm::cross(normal, side));
  const glm::vec3 other = glm::cross(normal, tangent);
  for (const glm::vec3& aside : {glm::vec3(0), tangent, -tangent, other, -other})
    if (!closest_hit_(point + offset_ * normal, glm::normalize(normal + aside))) return true;
  return false;
}

bool LightReach::lit(const glm::vec3& point, const glm::vec3& normal) const {
  if (sky_) return sees_sky(point, normal);
  std::vector<Ray> rays;
  for (const Light& light : lights_) {
    const Ray ray = ray_to(light, point, normal);
    if (ray.radiance > 0) rays.push_back(ray);
  }
  std::stable_sort(rays.begin(), rays.end(),
                   [](const Ray& a, const Ray& b) { return a.radiance > b.radiance; });
  const std::size_t count = std::min(rays.size(), kMostShadowRays);
  float radiance = 0;
  for (std::size_t i = 0; i < count && radiance < kDimmest; ++i)
    if (reached(rays[i], point, normal)) radiance += rays[i].radiance;
  return radiance >= kDimmest;
}

}  // namespace lightbench
