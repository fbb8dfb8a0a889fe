#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/obj_parser.h"
#include "scene/scene.h"
#include "scene/texture_options.h"

namespace lightbench {

struct MeshOptions {
  float crease_angle = 0.698f;            ///< radians; for normals that neither `vn` nor `s` says
  std::vector<bool> material_has_cutout;  ///< of each of ObjData::materials
  std::vector<TexturePlacement> material_placement = {};  ///< the same; may be empty
};

/// Faces that were left out, and what else was done to the file's geometry.
struct MeshStatistics {
  std::size_t degenerate_triangles = 0;  ///< no area, or next to none
  std::size_t duplicate_triangles = 0;   ///< in the place of an earlier one, or parts of such a face
  std::size_t crossing_faces = 0;        ///< whose edges cross, so that no triangles are right
  std::size_t bad_normals = 0;           ///< given, but zero; computed instead
};

struct BuiltMeshes {
  /// One for each object or group that has triangles; the parts' materials index ObjData::materials, -1 for
  /// none.
  std::vector<Mesh> meshes;
  /// The file's coordinates less those of the meshes. It is not 0 only where the model lies so far from the
  /// file's origin, for its size, that 32-bit floats would lose its shape.
  glm::dvec3 origin{0};
  MeshStatistics statistics;
};

/// Triangulates, drops triangles without area and faces that stand twice, and fills in missing normals: from
/// smoothing groups where the file has any, else from the faces that meet at equal positions. Of two
/// coincident faces the first stays, since nothing says which of them a picture shows; both stay where their
/// materials differ and one of them has a cut-out.
BuiltMeshes build_meshes(const ObjData& data, const MeshOptions& options);

}  // namespace lightbench
