#include "scene/obj_loader.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/color.h"
#include "base/hash.h"
#include "base/text.h"
#include "scene/material_libraries.h"
#include "scene/mesh_builder.h"
#include "scene/obj_parser.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

std::set<std::string> names_of(const std::vector<TextLine>& lines) {
  std::set<std::string> names;
  for (const TextLine& line : lines) names.insert(line.text);
  return names;
}

void decode(std::vector<glm::vec3>& colors) {
  for (glm::vec3& c : colors) c = {srgb_decode(c.x), srgb_decode(c.y), srgb_decode(c.z)};
}

class ObjLoader {
 public:
  ObjLoader(const fs::path& file, TextureLoader& textures, ProblemList& problems)
      : file_(file),
        textures_(textures),
        problems_(problems),
        unknown_materials_(problems, Problem::Severity::warning, "materials that no library has",
                           file.string()) {}

  ObjModel run(const ObjOptions& options) {
    ObjData data;
    std::string hash = hash_while_reading(file_, [&] { data = parse_obj(file_, problems_); });
    model_.files.push_back({file_, std::move(hash)});
    if (options.vertex_colors == VertexColors::srgb) decode(data.colors);
    if (data.shapes.size() > kMostMeshes) merge_shapes(data);
    MeshOptions mesh_options{.crease_angle = options.crease_angle, .material_has_cutout = {}};
    read_materials(data, mesh_options);
    build(data, mesh_options);
    report_materials();
    return std::move(model_);
  }

 private:
  static void merge_shapes(ObjData& data) {
    data.shapes = {""};
    for (ObjFace& face : data.faces) face.shape = 0;
  }

  void read_materials(const ObjData& data, MeshOptions& options) {
    const std::set<std::string> used = names_of(data.materials);
    MaterialLibraries libraries(file_, used, problems_);
    for (const TextLine& statement : data.material_libraries) libraries.read(statement);
    model_.files.insert(model_.files.end(), libraries.files().begin(), libraries.files().end());
    for (const TextLine& use : data.materials) {
      add_material(use, libraries);
      options.material_has_cutout.push_back(model_.materials.back().cutout_texture != kNoTexture);
      options.material_placement.push_back(placement(libraries.find(use.text)));
    }
    for (const auto& [name, unused] : libraries.materials())
      if (!used.contains(name)) model_.unused_materials.push_back(name);
  }

  void add_material(const TextLine& use, const MaterialLibraries& libraries) {
    Material& material = model_.materials.emplace_back();
    material.name = use.text;
    if (const MtlMaterial* found = libraries.find(use.text)) return fill(material, *found);
    if (libraries.lacks_one()) return;
    unknown_materials_.add(
        [&] {
          return fmt::format("no material library has the material '{}'{}; it is plain grey", use.text,
                             did_you_mean(use.text, libraries.materials()));
        },
        at_line(file_, use.line));
  }

  // Returns how the textures of the last material lie: both alike, since a vertex has one texture coordinate.
  TexturePlacement placement(const MtlMaterial* m) {
    const Material& material = model_.materials.back();
    if (!m) return {};
    if (material.diffuse_texture == kNoTexture) return m->cutout_map.placement;
    if (material.cutout_texture != kNoTexture && m->cutout_map.placement != m->diffuse_map.placement)
      unshown_["-s and -o of map_d (those of map_Kd are used)"].push_back(m->name);
    return m->diffuse_map.placement;
  }

  void fill(Material& material, const MtlMaterial& m) {
    material.diffuse = m.diffuse;
    material.specular = (m.specular.x + m.specular.y + m.specular.z) / 3;
    // An exponent of 0 is meant as no highlight at all, but would cover everything with one.
    material.exponent = std::max(m.exponent, 1.0f);
    if (m.exponent < 1 && material.specular > 0) unshown_["an Ns below 1 (1 is used)"].push_back(m.name);
    material.emission = m.emission;
    if (m.specular.x != m.specular.y || m.specular.y != m.specular.z)
      unshown_["the colour of Ks (its mean is used)"].push_back(m.name);
    for (const std::string& kind : std::set(m.unshown.begin(), m.unshown.end()))
      unshown_[kind].push_back(m.name);
    read_textures(material, m);
  }

  void read_textures(Material& material, const MtlMaterial& m) {
    const fs::path folder = m.file.parent_path();
    const auto where = [&](const MtlTexture& texture) { return at_line(m.file, texture.line); };
    if (!m.diffuse_map.name.empty())
      material.diffuse_texture = textures_.color(m.diffuse_map.name, folder, where(m.diffuse_map));
    if (m.cutout_map.name.empty()) return;
    material.cutout_texture =
        textures_.cutout(m.cutout_map.name, folder, where(m.cutout_map), material.diffuse_texture);
    if (material.diffuse_texture == kNoTexture || material.cutout_texture != kNoTexture) return;
    if (textures_.color(m.cutout_map.name, folder, where(m.cutout_map)) == material.diffuse_texture)
      unshown_["map_d (the file of map_Kd, which has no alpha)"].push_back(m.name);
  }

  void build(const ObjData& data, const MeshOptions& options) {
    BuiltMeshes built = build_meshes(data, options);
    model_.meshes = std::move(built.meshes);
    model_.origin = built.origin;
    for (Mesh& mesh : model_.meshes)
      for (MeshPart& part : mesh.parts)
        if (part.material < 0) part.material = default_material();
    report_geometry(data, built.statistics);
  }

  // For faces before the first usemtl, and after one without a name.
  int default_material() {
    if (default_material_ < 0) {
      default_material_ = int(model_.materials.size());
      model_.materials.emplace_back().name = "default";
      problems_.note("faces without a material are shown in grey 0.8", file_.string());
    }
    return default_material_;
  }

  void report_geometry(const ObjData& data, const MeshStatistics& statistics) {
    const std::string where = file_.string();
    if (model_.meshes.empty())
      problems_.error(data.faces.empty() ? "has no faces" : "all of its faces are without area", where);
    if (statistics.degenerate_triangles > 0)
      problems_.note(fmt::format("{} triangles without area are left out", statistics.degenerate_triangles),
                     where);
    if (statistics.duplicate_triangles > 0)
      problems_.note(
          fmt::format("{} triangles that stand twice are left out", statistics.duplicate_triangles), where);
    if (statistics.crossing_faces > 0)
      problems_.note(fmt::format("{} faces have edges that cross, seen flat: no triangles cover them exactly",
                                 statistics.crossing_faces),
                     where);
    if (statistics.bad_normals > 0)
      problems_.warning(
          fmt::format("{} corners have a normal of zero length, or one that is not finite; it is computed",
                      statistics.bad_normals),
          where);
    report_missing_uvs();
  }

  // Warns of materials with a texture that no mesh with texture coordinates uses.
  void report_missing_uvs() {
    std::vector<bool> used(model_.materials.size()), used_with_uvs(model_.materials.size());
    for (const Mesh& mesh : model_.meshes)
      for (const MeshPart& part : mesh.parts) {
        used[std::size_t(part.material)] = true;
        if (!mesh.uvs.empty()) used_with_uvs[std::size_t(part.material)] = true;
      }
    for (std::size_t i = 0; i < model_.materials.size(); ++i) {
      const Material& m = model_.materials[i];
      const bool textured = m.diffuse_texture != kNoTexture || m.cutout_texture != kNoTexture;
      if (textured && used[i] && !used_with_uvs[i])
        unshown_["a texture, without texture coordinates"].push_back(m.name);
    }
  }

  void report_materials() {
    const fs::path& where = model_.files.size() > 1 ? model_.files[1].path : file_;
    for (const auto& [kind, names] : unshown_)
      problems_.warning(fmt::format("not shown: {} of {}", kind, counted_names("materials", names)),
                        where.string());
  }

  const fs::path& file_;
  TextureLoader& textures_;
  ProblemList& problems_;
  RepeatedProblem unknown_materials_;
  ObjModel model_;
  std::map<std::string, std::vector<std::string>> unshown_;
  int default_material_ = -1;
};

}  // namespace

ObjModel load_obj(const fs::path& file, const ObjOptions& options, TextureLoader& textures,
                  ProblemList& problems) {
  return ObjLoader(file, textures, problems).run(options);
}

}  // namespace lightbench
