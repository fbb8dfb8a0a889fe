#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "scene/problem_list.h"
#include "scene/scene_json.h"

namespace lightbench {

/// Changes materials of a scene by their names, as the scene file says.
class MaterialOverrides {
 public:
  /// `unused` are materials that no face has; `where` is the place of all overrides.
  MaterialOverrides(std::vector<Material>& materials, const std::set<std::string>& unused,
                    ProblemList& problems, const std::string& where);

  /// A name that some material has is that name; else it may be a pattern. One that matches nothing is a
  /// problem.
  void apply(const std::string& name, const MaterialPatch& patch, const std::string& where);

 private:
  bool apply_to_matching(const std::string& pattern, const MaterialPatch& patch);
  bool names_unused(const std::string& pattern) const;

  std::vector<Material>& materials_;
  ProblemList& problems_;
  RepeatedProblem unknown_;
  std::map<std::string, std::vector<std::size_t>> by_name_;  // of a material that no face has, none
};

}  // namespace lightbench
