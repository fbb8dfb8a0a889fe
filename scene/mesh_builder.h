#pragma once

#include <cstddef>
#include <vector>

#include "scene/obj_parser.h"
#include "scene/scene.h"

namespace lightbench {

struct MeshOptions {
  float crease_angle = 0.698f;            ///< radians; for normals that the file lacks
  std::vector<bool> material_has_cutout;  ///< of each of ObjData::materials
};

/// Faces that were left out, and what else was done to the file's geometry.
struct MeshStatistics {
  std::size_t degenerate_triangles = 0;  ///< no area, or next to none
  std::size_t duplicate_triangles = 0;   ///< the corners of an earlier one, in whatever order
  std::size_t bad_normals = 0;           ///< given, but zero; computed instead
};

struct BuiltMeshes {
  /// One for each object or group that has triangles; the parts' materials index ObjData::materials, -1 for
  /// none.
  std::vector<Mesh> meshes;
  MeshStatistics statistics;
};

/// Triangulates, drops triangles without area and triangles that stand twice, and fills in missing normals
/// from the faces that meet at equal positions. Of two coincident triangles the first stays, since nothing
/// says which of them a picture shows; both stay where their materials differ and one of them has a cut-out.
BuiltMeshes build_meshes(const ObjData& data, const MeshOptions& options);

}  // namespace lightbench
