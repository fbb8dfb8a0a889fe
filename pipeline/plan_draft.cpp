#include "pipeline/plan_draft.h"

#include "base/files.h"
#include "base/text.h"
#include "pipeline/concrete.h"

namespace lightbench {
namespace {

/// Of tasks that are not known to take longer.
constexpr double kTaskTimeout = 1800;

}  // namespace

PlanDraft::PlanDraft(const Job& job, const PlanFacts& facts, const std::filesystem::path& out)
    : facts_(facts) {
  plan_.job = job;
  plan_.out = out;
  plan_.gl = facts.gl;
  for (const SceneFacts& scene : facts.scenes) plan_.scene_hashes.push_back(key_of(scene.files));
}

const View& PlanDraft::view(int scene, int view) const {
  return views_of(job().scenes[std::size_t(scene)])[std::size_t(view)];
}

Task PlanDraft::start(TaskKind kind, int scene, int view, const std::vector<std::string>& names) const {
  Task task;
  task.kind = kind;
  task.scene = scene;
  task.view = view;
  std::vector<std::string> plain = {job().scenes[std::size_t(scene)].name};
  if (view != kNone) plain.push_back(this->view(scene, view).name);
  plain.insert(plain.end(), names.begin(), names.end());
  std::vector<std::string> escaped;
  for (const std::string& name : plain) escaped.push_back(escape_file_name(name));
  task.id = to_text(kind) + ":" + join(escaped, "/");
  task.label = join(plain, "/");
  task.timeout_seconds = kTaskTimeout;
  task.refused = facts(scene).error;
  return task;
}

std::size_t PlanDraft::add(Task task) {
  task.key = key_of(task.key_parts);
  plan_.tasks.push_back(std::move(task));
  return plan_.tasks.size() - 1;
}

void add_files(KeyParts& parts, const SceneFacts& facts) {
  for (const auto& [name, hash] : facts.files) parts.emplace_back("file " + name, hash);
}

}  // namespace lightbench
