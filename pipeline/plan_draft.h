#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/plan.h"

namespace lightbench {

/// A plan in the making and what it is made from, which must outlive it.
class PlanDraft {
 public:
  PlanDraft(const Job& job, const PlanFacts& facts, const std::filesystem::path& out);

  const Job& job() const { return plan_.job; }
  const JobVariant& variant(int index) const { return job().variants[std::size_t(index)]; }
  const View& view(int scene, int view) const;
  const PlanFacts& facts() const { return facts_; }
  const SceneFacts& facts(int scene) const { return facts_.scenes[std::size_t(scene)]; }
  const std::vector<Task>& tasks() const { return plan_.tasks; }

  /// A task called by the names of its scene, its view if it has one, and `names`; refused where the scene
  /// cannot be used.
  Task start(TaskKind kind, int scene, int view, const std::vector<std::string>& names) const;

  /// Gives the task its key and adds it to the plan; returns its index.
  std::size_t add(Task task);

  Plan take() && { return std::move(plan_); }

 private:
  const PlanFacts& facts_;
  Plan plan_;
};

/// Has a key depend on all that was read of a scene.
void add_files(KeyParts& parts, const SceneFacts& facts);

}  // namespace lightbench
