#include "pipeline/selection.h"

#include <algorithm>

#include "base/text.h"

namespace lightbench {

bool is_selected(const std::string& label, const std::string& only) {
  return only.empty() || label == only || label.starts_with(only + "/") || matches_glob(label, only) ||
         matches_glob(label, only + "/*");
}

std::vector<bool> select_tasks(const Plan& plan, const std::set<TaskKind>& stages, const std::string& only) {
  const auto in_stages = [&](const Task& task) {
    if (stages.empty() || stages.contains(task.kind)) return true;
    if (task.kind == TaskKind::export_) return stages.contains(TaskKind::reference);
    const bool makes_objects = task.kind == TaskKind::bake || task.kind == TaskKind::compress;
    return makes_objects && stages.contains(TaskKind::snapshot);
  };
  std::vector<bool> selected(plan.tasks.size(), false);
  for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
    selected[i] = is_selected(plan.tasks[i].label, only) && in_stages(plan.tasks[i]);
  }
  for (std::size_t i = plan.tasks.size(); i-- > 0;)
    if (selected[i])
      for (const std::size_t dep : plan.tasks[i].deps)
        if (in_stages(plan.tasks[dep])) selected[dep] = true;
  return selected;
}

std::vector<bool> select_failed(const Plan& plan, const std::map<std::string, LedgerEntry>& last) {
  std::vector<bool> selected(plan.tasks.size(), false);
  for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
    const auto entry = last.find(plan.tasks[i].id);
    const auto& deps = plan.tasks[i].deps;
    selected[i] = (entry != last.end() && entry->second.outcome == Outcome::failed) ||
                  std::any_of(deps.begin(), deps.end(), [&](std::size_t dep) { return selected[dep]; });
  }
  for (std::size_t i = plan.tasks.size(); i-- > 0;)
    if (selected[i])
      for (const std::size_t dep : plan.tasks[i].deps) selected[dep] = true;
  return selected;
}

}  // namespace lightbench
