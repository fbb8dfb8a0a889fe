#include "scene/scene_models.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "scene/model_origin.h"
#include "scene/nearest_surface.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

// A scene's models may have this many triangles in all, as many as one file may hold. A model counts once,
// however many entities show it.
constexpr std::size_t kMostTriangles = 50'000'000;

}  // namespace

PlacedModel SceneModels::model(const fs::path& file, const ModelOptions& options) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(file, error);
  const auto key = std::tuple(error ? file : canonical, options.crease_angle, options.vertex_colors);
  const auto [found, is_first] = models_.try_emplace(key);
  return is_first ? found->second = read(file, options) : found->second;
}

PlacedModel SceneModels::read(const fs::path& file, const ModelOptions& options) {
  ObjModel loaded = load_obj(file, {float(glm::radians(options.crease_angle)), options.vertex_colors},
                             textures_, problems_);
  PlacedModel placed{int(scene_.meshes.size()), int(loaded.meshes.size()), loaded.origin};
  const int first_material = int(scene_.materials.size());
  for (Material& material : loaded.materials) scene_.materials.push_back(std::move(material));
  for (Mesh& mesh : loaded.meshes) {
    triangles_ += mesh.triangles.size();
    if (triangles_ > kMostTriangles)
      throw Error(fmt::format("the scene's models have more than {} triangles", kMostTriangles),
                  file.string());
    for (MeshPart& part : mesh.parts) part.material += first_material;
    for (const glm::vec3& p : mesh.positions) placed.bounds.add(p);
    scene_.meshes.push_back(std::move(mesh));
  }
  unused_materials_.insert(loaded.unused_materials.begin(), loaded.unused_materials.end());
  for (const SourceFile& read : loaded.files) add_file(read);
  return placed;
}

// A model that stands in the scene with several crease angles is read several times.
void SceneModels::add_file(const SourceFile& file) {
  const auto [known, is_new] = files_.try_emplace(file.path, file.hash);
  if (is_new) scene_.files.push_back(file);
  if (known->second != file.hash) throw Error("was changed while the scene was read", file.path.string());
}

glm::mat4 model_transform(const glm::dmat4& entity, const glm::mat4& model, const glm::dvec3& origin) {
  // Without an origin all is done in floats, so that what was published stays the same to the last bit.
  if (origin == glm::dvec3(0)) return glm::mat4(entity) * model;
  return glm::mat4(glm::translate(entity * glm::dmat4(model), origin));
}

void check_distance(const PlacedModel& model, const Entity& entity, const std::string& where,
                    ProblemList& problems) {
  if (model.origin == glm::dvec3(0) || model.bounds.empty() || !entity.motion.keys.empty()) return;
  Bounds bounds;
  for (const glm::vec3& corner : corners(model.bounds)) bounds.add(transform_point(entity.transform, corner));
  const glm::dvec3 size = glm::dvec3(model.bounds.max) - glm::dvec3(model.bounds.min);
  const glm::dmat3 turn(glm::dmat4(entity.transform));
  const double length =
      glm::length(turn[0] * size.x) + glm::length(turn[1] * size.y) + glm::length(turn[2] * size.z);
  const glm::dvec3 middle(entity.transform[3]);
  if (!(glm::length(middle) > kFarAway * length)) return;
  const glm::vec3 farthest = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
  const float largest = std::max({farthest.x, farthest.y, farthest.z});
  const float step = std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest;
  problems.warning(
      fmt::format(
          "the model '{}' lies so far from the origin that 32-bit floats lose its shape: at {:.7g} they "
          "are {:.2g} apart. Move it by [{:.10g}, {:.10g}, {:.10g}], with 'translate' in a scene file",
          entity.name, largest, step, 0 - middle.x, 0 - middle.y, 0 - middle.z),
      where);
}

}  // namespace lightbench
