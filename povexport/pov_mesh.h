#pragma once

#include "povexport/pov_materials.h"
#include "povexport/pov_writer.h"
#include "scene/scene.h"

namespace lightbench {

/// The object of a mesh: one mesh2, without normals if all of its triangles are flat. Asks `materials` for
/// the textures that it needs. Nothing is written for a mesh without triangles. Positions are multiplied by
/// `scale`. Numbers are written so that POV-Ray reads them soon: docs/reference.md says what that gains.
PovWriter pov_mesh(const Mesh& mesh, float scale, PovMaterials& materials);

}  // namespace lightbench
