#pragma once

#include <filesystem>
#include <vector>

#include "scene/mtl_loader.h"
#include "scene/obj_parser.h"
#include "scene/scene.h"
#include "scene/texture_loader.h"

namespace lightbench {

/// An OBJ file with its materials. There is one mesh for each object or group (o, g) that has faces, named
/// after it, with one part for each of its materials: renderers cull by mesh. A file of more than kMostMeshes
/// of them becomes a single mesh, since each mesh costs a draw call.
struct ObjModel {
  std::vector<Mesh> meshes;                   ///< the parts' materials index `materials`
  std::vector<Material> materials;            ///< those that faces use
  std::vector<std::string> unused_materials;  ///< names of the others in the MTL files
  std::vector<SourceFile> files;              ///< the OBJ and its MTL files
};

/// Reads an OBJ file, its MTL files and, into `textures`, their textures. `crease_angle` is in radians. All
/// that is wrong is listed in `problems`; then the model is what could be read.
ObjModel load_obj(const std::filesystem::path& file, float crease_angle, TextureLoader& textures,
                  ProblemList& problems);

}  // namespace lightbench
