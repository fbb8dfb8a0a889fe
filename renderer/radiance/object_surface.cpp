#include "renderer/radiance/object_surface.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace lightbench {
namespace {

// From how far above a point is looked at, as a share of its largest coordinate: far more than positions are
// rounded by, so that the way back is as exact as that of any ray.
constexpr float kAbove = 1e-3f;

}  // namespace

ObjectSurface::ObjectSurface(const PathScene& scene, std::size_t entity)
    : scene_(scene),
      entity_(scene.scene.entities[entity]),
      mesh_(scene.scene.meshes[std::size_t(entity_.mesh)]),
      numbers_(mesh_.triangles.size()) {
  const std::vector<PlacedGeometry>& placed = scene.embree.placed();
  for (unsigned place = 0; place < placed.size(); ++place) {
    if (placed[place].entity != &entity_) continue;
    for (unsigned set = 0; set < placed[place].sets.size(); ++set) {
      const auto& triangles = placed[place].sets[set].triangles;
      for (unsigned i = 0; i < triangles.size(); ++i)
        numbers_[triangles[i]] = placed[place].instanced ? HitNumbers{place, set, i}
                                                         : HitNumbers{RTC_INVALID_GEOMETRY_ID, place, i};
    }
  }
}

/// As if a ray from straight above had hit the point.
void ObjectSurface::put_lane(RTCRayHit8& rays, int lane, const MeshPoint& point, Side side) const {
  const glm::uvec3& t = mesh_.triangles[point.triangle];
  const auto in_world = [&](const glm::vec3& p) { return glm::vec3(entity_.transform * glm::vec4(p, 1)); };
  const glm::vec3 &a = mesh_.positions[t.x], &b = mesh_.positions[t.y], &c = mesh_.positions[t.z];
  const glm::vec3 corner = in_world(a), edge_u = in_world(b) - corner, edge_v = in_world(c) - corner;
  const glm::vec3 position = corner + point.beta * edge_u + point.gamma * edge_v;
  const HitNumbers& numbers = numbers_[point.triangle];
  const bool instanced = numbers.instance != RTC_INVALID_GEOMETRY_ID;
  const glm::vec3 face = instanced ? glm::cross(b - a, c - a) : glm::cross(edge_u, edge_v);
  const SurfacePoint found = scene_.surfaces.point(numbers.instance, numbers.geometry, numbers.primitive,
                                                   point.beta, point.gamma, face);
  const bool along = glm::dot(found.face, found.normal) >= 0;
  const float length = glm::length(found.face);
  const glm::vec3 up =
      length > 0 ? found.face / (along == (side == Side::front) ? length : -length) : glm::vec3(0, 1, 0);
  const glm::vec3 size = glm::abs(position);
  const float above = kAbove * std::max({size.x, size.y, size.z, 1e-6f});
  const glm::vec3 origin = position + above * up;
  rays.ray.org_x[lane] = origin.x, rays.ray.org_y[lane] = origin.y, rays.ray.org_z[lane] = origin.z;
  rays.ray.dir_x[lane] = -up.x, rays.ray.dir_y[lane] = -up.y, rays.ray.dir_z[lane] = -up.z;
  rays.ray.tfar[lane] = above;
  rays.hit.Ng_x[lane] = face.x, rays.hit.Ng_y[lane] = face.y, rays.hit.Ng_z[lane] = face.z;
  rays.hit.u[lane] = point.beta, rays.hit.v[lane] = point.gamma;
  rays.hit.primID[lane] = numbers.primitive;
  rays.hit.geomID[lane] = numbers.geometry;
  rays.hit.instID[0][lane] = numbers.instance;
}

Surfaces8 ObjectSurface::at(const std::array<MeshPoint, kLanes>& points, Side side) const {
  RTCRayHit8 rays{};
  for (int lane = 0; lane < kLanes; ++lane) put_lane(rays, lane, points[std::size_t(lane)], side);
  return scene_.surfaces.shade(rays, first_lanes(kLanes));
}

}  // namespace lightbench
