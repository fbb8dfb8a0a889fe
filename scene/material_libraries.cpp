#include "scene/material_libraries.h"

#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/hash.h"

namespace lightbench {
namespace fs = std::filesystem;

MaterialLibraries::MaterialLibraries(const fs::path& obj_file, const std::set<std::string>& used,
                                     ProblemList& problems)
    : obj_file_(obj_file),
      used_(used),
      problems_(problems),
      missing_(problems, Problem::Severity::error, "material libraries that cannot be read",
               obj_file.string()),
      duplicates_(problems, Problem::Severity::warning, "materials that stand in several libraries",
                  obj_file.string()) {}

void MaterialLibraries::read(const TextLine& statement) {
  const std::string where = at_line(obj_file_, statement.line);
  const fs::path folder = obj_file_.parent_path();
  for (const std::string& name : names_on_line(statement.text, folder, ".mtl")) {
    const auto found = named_files_.find(name, folder);
    if (!found) {
      missing_.add(
          fmt::format("the material library '{}' {}", (folder / name).string(), why_not_found(name, folder)),
          where);
      lacks_one_ = true;
      continue;
    }
    if (!known_.insert(found->file).second) continue;
    if (found->found_elsewhere)
      problems_.warning(
          fmt::format("there is no material library '{}'; '{}' is used", name, found->file.string()), where);
    read_file(found->file);
  }
}

void MaterialLibraries::read_file(const fs::path& file) {
  const auto is_used = [&](const std::string& name) {
    return used_.contains(name) && !materials_.contains(name);
  };
  try {
    std::vector<MtlMaterial> materials;
    std::string hash =
        hash_while_reading(file, [&] { materials = load_mtl(file, problems_, kMostMaterials, is_used); });
    files_.push_back({file, std::move(hash)});
    for (MtlMaterial& m : materials) add(std::move(m));
  } catch (const Error& error) {
    problems_.add(error);
    lacks_one_ = true;
  }
}

void MaterialLibraries::add(MtlMaterial&& material) {
  const std::string name = material.name;
  const std::string where = at_line(material.file, material.line);
  const auto [first, is_first] = materials_.try_emplace(name, std::move(material));
  if (is_first || !used_.contains(name)) return;
  duplicates_.add(
      fmt::format("material '{}' stands in '{}' too, which was read first and counts for all faces", name,
                  first->second.file.string()),
      where);
}

const MtlMaterial* MaterialLibraries::find(const std::string& name) const {
  const auto found = materials_.find(name);
  return found == materials_.end() ? nullptr : &found->second;
}

}  // namespace lightbench
