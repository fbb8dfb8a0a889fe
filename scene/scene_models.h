#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include <glm/vec3.hpp>

#include "scene/obj_loader.h"
#include "scene/problem_list.h"
#include "scene/scene.h"
#include "scene/texture_loader.h"

namespace lightbench {

/// Where an OBJ's meshes stand in the scene.
struct PlacedModel {
  int first_mesh = 0;
  int mesh_count = 0;
  glm::dvec3 origin{0};  ///< the file's coordinates less the meshes': see BuiltMeshes
  Bounds bounds = {};    ///< of the meshes
};

/// How an OBJ file is read for a scene; several entities may read it in several ways.
struct ModelOptions {
  double crease_angle = 40;  ///< degrees
  VertexColors vertex_colors = VertexColors::srgb;
};

/// Reads OBJ files into a scene, each once.
class SceneModels {
 public:
  SceneModels(Scene& scene, TextureLoader& textures, ProblemList& problems)
      : scene_(scene), textures_(textures), problems_(problems) {}

  /// The model of an OBJ file, read at its first use. One that cannot be read is a problem then, and empty
  /// after that.
  PlacedModel model(const std::filesystem::path& file, const ModelOptions& options);
  /// Throws Error where the file was read before, and has changed.
  void add_file(const SourceFile& file);

  /// Names of materials in MTL files that no face has.
  const std::set<std::string>& unused_materials() const { return unused_materials_; }

 private:
  PlacedModel read(const std::filesystem::path& file, const ModelOptions& options);

  Scene& scene_;
  TextureLoader& textures_;
  ProblemList& problems_;
  std::map<std::tuple<std::filesystem::path, double, VertexColors>, PlacedModel> models_;
  std::map<std::filesystem::path, std::string> files_;  // hashes of the scene file and of all models' files
  std::size_t triangles_ = 0;                           // of all models
  std::set<std::string> unused_materials_;
};

/// The transform of an entity that shows a model: what its entity says, after what turns and scales the
/// model. A far origin is taken in before anything is rounded to floats.
glm::mat4 model_transform(const glm::dmat4& entity, const glm::mat4& model, const glm::dvec3& origin);

/// Warns where an entity brings a model that lies far from its file's origin to no nearer place, so that
/// 32-bit floats lose its shape.
void check_distance(const PlacedModel& model, const Entity& entity, const std::string& where,
                    ProblemList& problems);

}  // namespace lightbench
