#include "scene/obj_loader.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "scene/mesh_builder.h"
#include "scene/named_files.h"
#include "scene/obj_parser.h"

namespace lightbench {
namespace fs = std::filesystem;
namespace {

using MaterialMap = std::map<std::string, MtlMaterial>;

class ObjLoader {
 public:
  ObjLoader(const fs::path& file, TextureLoader& textures, ProblemList& problems)
      : file_(file),
        textures_(textures),
        problems_(problems),
        missing_libraries_(problems, Problem::Severity::error, "material libraries that cannot be read",
                           file.string()),
        unknown_materials_(problems, Problem::Severity::warning, "materials that no library has",
                           file.string()) {}

  ObjModel run(float crease_angle) {
    ObjData data;
    std::string hash = hash_while_reading(file_, [&] { data = parse_obj(file_, problems_); });
    model_.files.push_back({file_, std::move(hash)});
    if (data.shapes.size() > kMostMeshes) merge_shapes(data);
    for (const TextLine& library : data.material_libraries) read_libraries(library);
    std::vector<int> material_of_name;
    for (const TextLine& use : data.materials) material_of_name.push_back(add_material(use));
    list_unused(data);
    build(data, crease_angle, material_of_name);
    report_materials();
    return std::move(model_);
  }

 private:
  static void merge_shapes(ObjData& data) {
    data.shapes = {""};
    for (ObjFace& face : data.faces) face.shape = 0;
  }

  // A line of `mtllib` names one file, which may have blanks, or several.
  std::vector<std::string> library_names(const std::string& text) {
    const fs::path folder = file_.parent_path();
    if (text.empty() || named_files_.find(text, folder)) return {text};
    std::vector<std::string> names;
    for (const std::string& word : split(text, ' '))
      if (!trimmed(word).empty()) names.push_back(trimmed(word));
    const bool all_there = std::all_of(
        names.begin(), names.end(), [&](const auto& n) { return named_files_.find(n, folder).has_value(); });
    return all_there ? names : std::vector{text};
  }

  void read_libraries(const TextLine& statement) {
    const std::string where = at_line(file_, statement.line);
    const fs::path folder = file_.parent_path();
    for (const std::string& name : library_names(statement.text)) {
      const auto found = named_files_.find(name, folder);
      if (!found) {
        missing_libraries_.add(fmt::format("the material library '{}' {}", (folder / name).string(),
                                           why_not_found(name, folder)),
                               where);
        missing_library_ = true;
        continue;
      }
      if (!libraries_.insert(found->file).second) continue;
      if (found->found_elsewhere)
        problems_.warning(
            fmt::format("there is no material library '{}'; '{}' is used", name, found->file.string()),
            where);
      read_library(found->file);
    }
  }

  void read_library(const fs::path& file) {
    try {
      std::vector<MtlMaterial> materials;
      std::string hash = hash_while_reading(file, [&] { materials = load_mtl(file, problems_); });
      model_.files.push_back({file, std::move(hash)});
      for (MtlMaterial& m : materials) {
        const std::string name = m.name;
        library_.try_emplace(name, std::move(m));
      }
    } catch (const Error& error) {
      problems_.add(error);
      missing_library_ = true;
    }
  }

  int add_material(const TextLine& use) {
    const auto found = library_.find(use.text);
    Material& material = model_.materials.emplace_back();
    material.name = use.text;
    if (found != library_.end()) {
      fill(material, found->second);
    } else if (!missing_library_) {
      unknown_materials_.add(
          [&] {
            return fmt::format("no material library has the material '{}'{}; it is plain grey", use.text,
                               did_you_mean(use.text, library_));
          },
          at_line(file_, use.line));
    }
    return int(model_.materials.size()) - 1;
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
    const fs::path folder = m.file.parent_path();
    if (!m.diffuse_map.text.empty())
      material.diffuse_texture =
          textures_.color(m.diffuse_map.text, folder, at_line(m.file, m.diffuse_map.line));
    if (!m.cutout_map.text.empty())
      material.cutout_texture = textures_.cutout(
          m.cutout_map.text, folder, at_line(m.file, m.cutout_map.line), material.diffuse_texture);
  }

  void list_unused(const ObjData& data) {
    std::set<std::string> used;
    for (const TextLine& use : data.materials) used.insert(use.text);
    for (const auto& [name, unused] : library_)
      if (!used.contains(name)) model_.unused_materials.push_back(name);
  }

  void build(const ObjData& data, float crease_angle, const std::vector<int>& material_of_name) {
    MeshOptions options;
    options.crease_angle = crease_angle;
    for (const int m : material_of_name)
      options.material_has_cutout.push_back(model_.materials[std::size_t(m)].cutout_texture != kNoTexture);
    BuiltMeshes built = build_meshes(data, options);
    model_.meshes = std::move(built.meshes);
    for (Mesh& mesh : model_.meshes)
      for (MeshPart& part : mesh.parts)
        part.material = part.material < 0 ? default_material() : material_of_name[std::size_t(part.material)];
    report_geometry(data, built.statistics);
  }

  // For faces before the first usemtl.
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
    if (statistics.bad_normals > 0)
      problems_.warning(
          fmt::format("{} corners have a normal of zero length; it is computed", statistics.bad_normals),
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
  RepeatedProblem missing_libraries_;
  RepeatedProblem unknown_materials_;
  NamedFiles named_files_;
  ObjModel model_;
  std::set<fs::path> libraries_;  // that were read
  MaterialMap library_;
  std::map<std::string, std::vector<std::string>> unshown_;
  int default_material_ = -1;
  bool missing_library_ = false;
};

}  // namespace

ObjModel load_obj(const fs::path& file, float crease_angle, TextureLoader& textures, ProblemList& problems) {
  return ObjLoader(file, textures, problems).run(crease_angle);
}

}  // namespace lightbench
