#pragma once

#include "povexport/pov_materials.h"
#include "povexport/pov_writer.h"
#include "scene/scene.h"

namespace lightbench {

/// The object of a mesh: one mesh2 of its flat triangles (all vertex normals on the face normal) and one of
/// its smooth ones. Asks `materials` for the textures that it needs. Nothing is written for a mesh without
/// triangles.
/// Positions are multiplied by `scale`.
PovWriter pov_mesh(const Mesh& mesh, float scale, PovMaterials& materials);

}  // namespace lightbench
