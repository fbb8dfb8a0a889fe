#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/paths/path_scene.h"

namespace lightbench {

enum class Side {
  front,  ///< that to which the modelled shading normals point
  back
};

/// A point of an object's mesh: P = p0 + beta e1 + gamma e2 in a triangle (thesis, eq. 2.10).
struct MeshPoint {
  std::uint32_t triangle;
  float beta, gamma;
};

/// Points of one entity's mesh as paths see surfaces.
class ObjectSurface {
 public:
  ObjectSurface(const PathScene& scene, std::size_t entity);

  /// The points as seen from straight above, on a side.
  Surfaces8 at(const std::array<MeshPoint, kLanes>& points, Side side) const;

 private:
  /// What a hit on a triangle names.
  struct HitNumbers {
    unsigned instance, geometry, primitive;
  };
  void put_lane(RTCRayHit8& rays, int lane, const MeshPoint& point, Side side) const;

  const PathScene& scene_;
  const Entity& entity_;
  const Mesh& mesh_;
  std::vector<HitNumbers> numbers_;  ///< by triangle of the mesh
};

}  // namespace lightbench
