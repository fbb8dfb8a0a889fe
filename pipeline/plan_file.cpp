#include "pipeline/plan_file.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/json_bytes.h"
#include "base/json_reader.h"
#include "pipeline/concrete.h"
#include "pipeline/job_file.h"

namespace lightbench {
namespace {

using Json = nlohmann::ordered_json;

Json task_json(const Task& task, const std::vector<Task>& tasks) {
  Json json = {{"id", task.id}, {"kind", to_text(task.kind)}, {"label", task.label}, {"key", task.key}};
  json["parts"] = Json::array();
  for (const auto& [name, value] : task.key_parts) json["parts"].push_back({name, value});
  json["outputs"] = task.outputs;
  json["deps"] = Json::array();
  for (const std::size_t dep : task.deps) json["deps"].push_back(tasks[dep].id);
  json["scene"] = task.scene;
  json["view"] = task.view;
  json["variant"] = task.variant;
  json["reference"] = task.reference;
  json["object"] = task.object;
  json["resources"] = {
      {"cores", task.resources.cores}, {"gpu", task.resources.gpu}, {"memory_mb", task.resources.memory_mb}};
  json["expected_seconds"] = task.expected_seconds;
  json["timeout_seconds"] = task.timeout_seconds;
  json["group"] = task.group;
  if (!task.refused.empty()) json["refused"] = task.refused;
  return json;
}

TaskKind kind_of(const JsonValue& value) {
  const auto& names = task_kind_names();
  const std::string name = value.choice(names);
  return static_cast<TaskKind>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::vector<std::string> texts(const JsonValue& list) {
  std::vector<std::string> result;
  for (const auto& item : list.items()) result.push_back(item.text());
  return result;
}

Resources resources_of(JsonObject json) {
  constexpr int kMost = std::numeric_limits<int>::max();
  Resources resources;
  resources.cores = int(json.at("cores").integer(0, kMost));
  resources.gpu = int(json.at("gpu").integer(0, kMost));
  resources.memory_mb = int(json.at("memory_mb").integer(0, kMost));
  json.finish();
  return resources;
}

/// Tasks of a plan, one after the other; each number that points at something is checked.
class TaskReader {
 public:
  explicit TaskReader(const Job& job) : job_(job) {}

  Task read(const JsonValue& value) {
    JsonObject json = value.object();
    Task task;
    task.id = json.at("id").text();
    task.kind = kind_of(json.at("kind"));
    task.label = json.at("label").text();
    task.key = json.at("key").text();
    for (const auto& part : json.at("parts").items()) task.key_parts.push_back(part_of(part));
    task.outputs = texts(json.at("outputs"));
    for (const auto& dep : json.at("deps").items()) task.deps.push_back(earlier(dep));
    read_indices(json, task);
    task.resources = resources_of(json.at("resources").object());
    task.expected_seconds = json.at("expected_seconds").number(0);
    task.timeout_seconds = json.at("timeout_seconds").number(0);
    task.group = json.at("group").text();
    if (const auto refused = json.find("refused")) task.refused = refused->text();
    json.finish();
    if (!ids_.try_emplace(task.id, ids_.size()).second) value.fail("the task '" + task.id + "' stands twice");
    return task;
  }

 private:
  static std::pair<std::string, std::string> part_of(const JsonValue& value) {
    const auto part = texts(value);
    if (part.size() != 2) value.fail("must be a name and a value");
    return {part[0], part[1]};
  }

  std::size_t earlier(const JsonValue& id) const {
    const auto found = ids_.find(id.text());
    if (found == ids_.end()) id.fail("is no task that stands before this one");
    return found->second;
  }

  static int index(const JsonValue& value, std::size_t count, bool needed) {
    return int(value.integer(needed ? 0 : kNone, static_cast<long long>(count) - 1));
  }

  void read_indices(JsonObject& json, Task& task) const {
    const auto is = [&](auto... kinds) { return ((task.kind == kinds) || ...); };
    using enum TaskKind;
    constexpr std::size_t kMost = std::numeric_limits<int>::max();
    task.scene = index(json.at("scene"), job_.scenes.size(), true);
    task.view = index(json.at("view"), views_of(job_.scenes[std::size_t(task.scene)]).size(),
                      is(snapshot, reference, score));
    task.variant = index(json.at("variant"), job_.variants.size(), is(bake, compress, snapshot, score));
    task.reference = index(json.at("reference"), job_.references.size(), is(export_, reference, score));
    task.object = index(json.at("object"), kMost, is(bake, compress));
    if (task.outputs.empty() && is(bake)) json.fail("a bake needs an output");
  }

  const Job& job_;
  std::map<std::string, std::size_t> ids_;
};

/// The job of a plan has nothing left to decide.
Job concrete_job(const JsonValue& value, const std::filesystem::path& file) {
  Job job = parse_job(value.raw().dump(), file, JobText::concrete);
  for (const auto& scene : job.scenes)
    if (!std::holds_alternative<std::vector<View>>(scene.views))
      value.fail("the views of scene '" + scene.name + "' are not written out");
  for (const auto& variant : job.variants)
    if (!variant.sweep.empty()) value.fail("the variant '" + variant.name + "' has a sweep");
  return job;
}

}  // namespace

std::string plan_to_json(const Plan& plan) {
  Json json = {{"format", kPlanFormatVersion}, {"out", plan.out.string()}, {"gl", plan.gl}};
  json["job_file"] = std::filesystem::absolute(plan.job.file).string();
  json["job"] = parse_json_text(job_text(plan.job));
  json["scene_hashes"] = plan.scene_hashes;
  json["tasks"] = Json::array();
  for (const auto& task : plan.tasks) json["tasks"].push_back(task_json(task, plan.tasks));
  return json_text(json, 1) + "\n";
}

Plan read_plan(const std::filesystem::path& file) {
  JsonObject json = JsonValue::parse_file(file, kOwnJson).object();
  if (json.at("format").integer() != kPlanFormatVersion)
    throw Error("is a plan of another version of lightbench", file.string());
  Plan plan;
  plan.out = json.at("out").text();
  plan.gl = json.at("gl").text();
  plan.job = concrete_job(json.at("job"), json.at("job_file").text());
  const JsonValue hashes = json.at("scene_hashes");
  plan.scene_hashes = texts(hashes);
  if (plan.scene_hashes.size() != plan.job.scenes.size()) hashes.fail("there must be one for each scene");
  TaskReader reader(plan.job);
  for (const auto& task : json.at("tasks").items()) plan.tasks.push_back(reader.read(task));
  json.finish();
  return plan;
}

}  // namespace lightbench
