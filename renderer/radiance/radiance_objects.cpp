#include "renderer/radiance/radiance_objects.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/error.h"
#include "renderer/radiance/object_bake.h"
#include "renderer/radiance/radiance_codecs.h"

namespace lightbench {
namespace {

std::string key_of(const std::filesystem::path& folder, const ParamValues& params) {
  return folder.string() + "\n" + bake_params_text(params) + codec_params_text(params);
}

/// Whether a triangle's corners run so that its front, to which the normals point, is seen anticlockwise.
bool runs_forward(const Mesh& mesh, const glm::uvec3& t) {
  const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
  return glm::dot(glm::cross(b - a, c - a), mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]) >= 0;
}

struct Vertices {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> uvs, texels;
};

Vertices vertices_of(const Mesh& mesh, const glm::mat4& transform, const ChartAtlas& atlas) {
  const bool mirrored = glm::determinant(glm::dmat3(glm::mat3(transform))) < 0;
  Vertices vertices;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const bool keep = runs_forward(mesh, t) != mirrored;
    for (const int corner : {0, keep ? 1 : 2, keep ? 2 : 1}) {
      vertices.positions.push_back(mesh.positions[t[corner]]);
      vertices.normals.push_back(mesh.normals[t[corner]]);
      vertices.uvs.push_back(mesh.uvs.empty() ? glm::vec2(0) : mesh.uvs[t[corner]]);
      vertices.texels.push_back(atlas.coordinates[i][std::size_t(corner)]);
    }
  }
  return vertices;
}

RadianceObject object_of(const Scene& scene, std::size_t entity, const ChartAtlas& atlas) {
  const Entity& source = scene.entities[entity];
  const Mesh& mesh = scene.meshes[std::size_t(source.mesh)];
  const Vertices vertices = vertices_of(mesh, source.transform, atlas);
  RadianceObject object;
  object.entity = int(entity);
  object.world_from_object = glm::dmat4(source.transform);
  for (const glm::vec3& position : vertices.positions) object.bounds.add(position);
  object.positions = buffer_of(vertices.positions);
  object.normals = buffer_of(vertices.normals);
  object.uvs = buffer_of(vertices.uvs);
  object.texels = buffer_of(vertices.texels);
  object.vertices.attribute(0, object.positions, 3);
  object.vertices.attribute(1, object.normals, 3);
  object.vertices.attribute(2, object.uvs, 2);
  object.vertices.attribute(3, object.texels, 2);
  for (const MeshPart& part : mesh.parts)
    object.ranges.push_back({int(3 * part.first_triangle), int(3 * part.triangle_count),
                             scene.materials[std::size_t(part.material)].cutout_texture});
  return object;
}

void check_fits(const RadianceFile& file, const ChartAtlas& atlas, const DirectionGrid& grid,
                const std::string& where) {
  const bool sides = file.height == atlas.height || file.height == 2 * atlas.height;
  if (file.width != atlas.width || !sides || !(file.grid == grid))
    throw Error(
        fmt::format("has {} x {} texels and {} x {} directions, which is not what the scene and the "
                    "parameters ask for ({} x {}, {} x {}): it was baked from another scene, or otherwise",
                    file.width, file.height, file.grid.thetas, file.grid.phis, atlas.width, atlas.height,
                    grid.thetas, grid.phis),
        where);
}

}  // namespace

RadianceObjects::RadianceObjects(const Scene& scene, const std::filesystem::path& folder,
                                 const ParamValues& params)
    : key_(key_of(folder, params)), file_bytes_(radiance_file_bytes(scene, folder, params)) {
  const BakeSettings settings = bake_settings(params);
  order_ = settings.trace.grid.order;
  for (const std::size_t entity : objects_to_bake(scene)) {
    const ChartAtlas atlas = object_atlas(scene, entity, settings);
    const std::filesystem::path stem = folder / object_file_stem(scene, entity);
    RadianceObject object = object_of(scene, entity, atlas);
    object.file = radiance_codec(params).load(stem, params);
    check_fits(object.file, atlas, object_grid(scene, entity, settings), stem.string());
    object.sides = object.file.height / atlas.height;
    objects_.push_back(std::move(object));
  }
}

bool RadianceObjects::are(const std::filesystem::path& folder, const ParamValues& params) const {
  return key_ == key_of(folder, params);
}

std::uint64_t radiance_file_bytes(const Scene& scene, const std::filesystem::path& folder,
                                  const ParamValues& params) {
  std::uint64_t bytes = 0;
  for (const std::size_t entity : objects_to_bake(scene))
    for (const char* extension : radiance_codec(params).extensions) {
      std::error_code missing;
      const auto size =
          std::filesystem::file_size(folder / (object_file_stem(scene, entity) + extension), missing);
      if (!missing) bytes += size;
    }
  return bytes;
}

}  // namespace lightbench
