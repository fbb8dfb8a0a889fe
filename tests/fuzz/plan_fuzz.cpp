#include "fuzz_input.h"
#include "pipeline/concrete.h"
#include "pipeline/plan_file.h"

namespace lightbench::fuzz {
namespace {

bool is_index(int index, std::size_t count) {
  return index == kNone || (index >= 0 && std::size_t(index) < count);
}

void require_indices(const Plan& plan, std::size_t number) {
  const Task& task = plan.tasks[number];
  for (const std::size_t dep : task.deps) require(dep < number, "a task that needs itself or a later one");
  require(is_index(task.scene, plan.job.scenes.size()), "a task of a scene that is not there");
  require(is_index(task.variant, plan.job.variants.size()), "a task of a variant that is not there");
  require(is_index(task.reference, plan.job.references.size()), "a task of a reference that is not there");
}

}  // namespace

/// A plan.json: a worker may believe its indices.
void fuzz_plan(std::string_view bytes) {
  static const InputFolder folder;
  const Plan plan = read_plan(folder.write("plan.json", bytes));
  for (std::size_t number = 0; number < plan.tasks.size(); ++number) require_indices(plan, number);
  plan_to_json(plan);
}

}  // namespace lightbench::fuzz
