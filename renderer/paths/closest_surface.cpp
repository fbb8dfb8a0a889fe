#include "renderer/paths/closest_surface.h"

namespace lightbench {

std::optional<SurfaceHit> closest_surface(const PathScene& scene, const glm::vec3& origin,
                                          const glm::vec3& direction, float near) {
  RTCRayHit ray{};
  ray.ray = {origin.x,    origin.y, origin.z, near,        direction.x, direction.y,
             direction.z, 0,        1e30f,    0xffffffffu, 0,           0};
  ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene.embree.top(), &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Entity* entity =
      scene.embree.triangle(ray.hit.instID[0], ray.hit.geomID, ray.hit.primID).place->entity;
  return SurfaceHit{std::size_t(entity - scene.scene.entities.data()),
                    glm::dvec3(origin) + double(ray.ray.tfar) * glm::dvec3(direction),
                    scene.surfaces.point(ray.hit.instID[0], ray.hit.geomID, ray.hit.primID, ray.hit.u,
                                         ray.hit.v, {ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z})};
}

}  // namespace lightbench
