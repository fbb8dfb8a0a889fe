#pragma once

#include <filesystem>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/obj_parser.h"
#include "scene/problem_list.h"
#include "scene/scene.h"
#include "scene/texture_loader.h"

namespace lightbench {

/// How the numbers of vertex colours (`v x y z r g b`) are meant. No specification says.
enum class VertexColors {
  srgb,  ///< as Blender, three.js and MeshLab take them
  linear,
};

struct ObjOptions {
  float crease_angle = 0.698f;  ///< radians; for normals that neither `vn` nor `s` says
  VertexColors vertex_colors = VertexColors::srgb;
};

/// An OBJ file with its materials. There is one mesh for each object or group (o, g) that has faces, named
/// after it, with one part for each of its materials: renderers cull by mesh. A file of more than kMostMeshes
/// of them becomes a single mesh, since each mesh costs a draw call.
struct ObjModel {
  std::vector<Mesh> meshes;                   ///< the parts' materials index `materials`
  std::vector<Material> materials;            ///< those that faces use
  std::vector<std::string> unused_materials;  ///< names of the others in the MTL files
  std::vector<SourceFile> files;              ///< the OBJ and its MTL files
  glm::dvec3 origin{0};                       ///< the file's coordinates less the meshes': see BuiltMeshes
};

/// Reads an OBJ file, its MTL files and, into `textures`, their textures. All that is wrong is listed in
/// `problems`; then the model is what could be read.
ObjModel load_obj(const std::filesystem::path& file, const ObjOptions& options, TextureLoader& textures,
                  ProblemList& problems);

}  // namespace lightbench
