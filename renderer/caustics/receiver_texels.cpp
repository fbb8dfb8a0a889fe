#include "renderer/caustics/receiver_texels.h"

#include <algorithm>
#include <optional>

#include <glm/geometric.hpp>

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

std::vector<ReceiverTexel> receiver_texels(const PathScene& scene, const ReceiverBox& box,
                                           std::size_t receiver, int size) {
  const glm::vec3 axis(-box.v);
  const double far_above = 1 + double(world_bounds(scene.scene).diagonal()) / box.size.y;
  std::vector<ReceiverTexel> texels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      ReceiverTexel& texel = texels.emplace_back();
      const glm::vec3 above(box.from_map({(x + 0.5) / size, (y + 0.5) / size, -far_above}));
      const float to_water = (scene.scene.water->height - above.y) / axis.y;
      const auto hit = closest_surface(scene, above, axis, std::max(to_water, 0.0f));
      if (!hit) continue;
      const glm::vec3 face = glm::normalize(hit->surface.face);
      texel = {float(box.to_map(hit->position).z), hit->entity == receiver,
               glm::dot(face, axis) > 0 ? -face : face, hit->surface.albedo};
    }
  return texels;
}

}  // namespace lightbench
