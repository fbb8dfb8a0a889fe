#include "renderer/rays.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "renderer/embree_scene.h"

namespace lightbench {

namespace {

// The two ends of a segment are shortened by this share of its length, and by at least so many units in the
// last place of the largest coordinate, which is what a point computed on a surface may be off.
constexpr float kSegmentEpsilon = 1e-4f;
constexpr float kSegmentUlps = 16.0f;

RTCRay make_ray(const glm::vec3& origin, const glm::vec3& direction, float near, float far) {
  RTCRay ray;
  std::memset(&ray, 0, sizeof ray);
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tnear = near;
  ray.tfar = far;
  ray.mask = 0xffffffffu;
  return ray;
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

float largest_component(const glm::vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

struct SceneRays::Impl {
  explicit Impl(const Scene& scene) : embree(scene) {}
  glm::vec3 normal(const RTCHit& hit) const;

  EmbreeScene embree;
};

/// From the triangle's vertices in double precision: Embree's own is in object space and short of digits on
/// slivers.
glm::vec3 SceneRays::Impl::normal(const RTCHit& hit) const {
  const auto [place, set, primitive] = embree.triangle(hit.instID[0], hit.geomID, hit.primID);
  const glm::uvec3& t = set->mesh->triangles[set->triangles[primitive]];
  const glm::dmat3 linear(glm::mat3(place->entity->transform));
  const auto& p = set->mesh->positions;
  const glm::dvec3 a = linear * (glm::dvec3(p[t.y]) - glm::dvec3(p[t.x]));
  const glm::dvec3 b = linear * (glm::dvec3(p[t.z]) - glm::dvec3(p[t.x]));
  // A mirroring transform turns the winding round, but not what is outside.
  const double side = glm::determinant(linear) < 0 ? -1.0 : 1.0;
  const glm::dvec3 n = side * glm::cross(a, b);
  const double length = glm::length(n);
  return length > 0 ? glm::vec3(n / length) : glm::vec3(0, 1, 0);
}

SceneRays::SceneRays(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
SceneRays::~SceneRays() = default;

std::optional<RayHit> SceneRays::closest_hit(const glm::vec3& origin, const glm::vec3& direction) const {
  if (!is_finite(origin) || !is_finite(direction) || direction == glm::vec3(0)) return std::nullopt;
  RTCRayHit query;
  query.ray = make_ray(origin, direction, 0, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(impl_->embree.top(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{query.ray.tfar, impl_->normal(query.hit)};
}

bool SceneRays::occluded(const glm::vec3& from, const glm::vec3& to) const {
  if (!is_finite(from) || !is_finite(to)) return false;
  const glm::vec3 segment = to - from;
  const float length = glm::length(segment);
  const float magnitude = std::max(largest_component(from), largest_component(to));
  const float rounding = kSegmentUlps * std::numeric_limits<float>::epsilon() * magnitude;
  if (!(length > 2 * rounding)) return false;
  const float epsilon = std::max(kSegmentEpsilon, rounding / length);
  RTCRay ray = make_ray(from, segment, epsilon, 1 - epsilon);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(impl_->embree.top(), &context, &ray);
  return ray.tfar < 0;  // Embree's mark of a hit
}

}  // namespace lightbench
