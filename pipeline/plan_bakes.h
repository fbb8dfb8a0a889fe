#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "pipeline/plan_draft.h"

namespace lightbench {

/// Plans what techniques draw from baked radiance: a task bakes an object, and where the codec keeps it
/// otherwise than baked, another compresses it. Variants that bake, or compress, alike share the tasks.
class BakePlanner {
 public:
  explicit BakePlanner(PlanDraft& draft) : draft_(draft) {}

  /// Has a snapshot wait for the objects that it draws, which its key and its memory then depend on.
  void need_objects(Task& snapshot);

 private:
  /// What makes the files that the variant draws, in the order of the scene's objects.
  const std::vector<std::size_t>& object_files(int scene, int variant);
  std::size_t add_bake(int scene, int variant, std::size_t object, const std::string& folder);
  std::size_t add_compression(int scene, int variant, std::size_t object, const std::string& folder,
                              std::size_t bake);

  PlanDraft& draft_;
  std::map<std::string, std::vector<std::size_t>> object_files_;  ///< by their folder
};

}  // namespace lightbench
