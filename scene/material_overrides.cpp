#include "scene/material_overrides.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"

namespace lightbench {

MaterialOverrides::MaterialOverrides(std::vector<Material>& materials, const std::set<std::string>& unused,
                                     ProblemList& problems, const std::string& where)
    : materials_(materials),
      problems_(problems),
      unknown_(problems, Problem::Severity::error, "materials that no model has", where) {
  for (std::size_t i = 0; i < materials.size(); ++i) by_name_[materials[i].name].push_back(i);
  for (const std::string& name : unused) by_name_.try_emplace(name);
}

void MaterialOverrides::apply(const std::string& name, const MaterialPatch& patch, const std::string& where) {
  if (const auto found = by_name_.find(name); found != by_name_.end() && !found->second.empty()) {
    for (const std::size_t i : found->second) patch.apply(materials_[i]);
    return;
  }
  if (apply_to_matching(name, patch)) return;
  if (names_unused(name)) return problems_.note(fmt::format("no face has the material '{}'", name), where);
  if (is_pattern(name)) return problems_.warning(fmt::format("no material matches '{}'", name), where);
  unknown_.add(
      [&] { return fmt::format("no model has the material '{}'{}", name, did_you_mean(name, by_name_)); },
      where);
}

bool MaterialOverrides::apply_to_matching(const std::string& pattern, const MaterialPatch& patch) {
  if (!is_pattern(pattern)) return false;
  bool used = false;
  for (Material& material : materials_) {
    if (!matches_glob(material.name, pattern)) continue;
    patch.apply(material);
    used = true;
  }
  return used;
}

// Called where no used material matches.
bool MaterialOverrides::names_unused(const std::string& pattern) const {
  if (by_name_.contains(pattern)) return true;
  return is_pattern(pattern) &&
         std::ranges::any_of(by_name_, [&](const auto& entry) { return matches_glob(entry.first, pattern); });
}

}  // namespace lightbench
