#include "pipeline/plan_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
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

TaskKind kind_of(const std::string& text) {
  const auto& names = task_kind_names();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == text) return static_cast<TaskKind>(i);
  throw Error("unknown kind of task '" + text + "'");
}

Task task_of(const Json& json, const std::map<std::string, std::size_t>& index) {
  Task task;
  task.id = json.at("id").get<std::string>();
  task.kind = kind_of(json.at("kind").get<std::string>());
  task.label = json.at("label").get<std::string>();
  task.key = json.at("key").get<std::string>();
  for (const auto& part : json.at("parts"))
    task.key_parts.emplace_back(part.at(0).get<std::string>(), part.at(1).get<std::string>());
  task.outputs = json.at("outputs").get<std::vector<std::string>>();
  for (const auto& dep : json.at("deps")) task.deps.push_back(index.at(dep.get<std::string>()));
  task.scene = json.at("scene").get<int>();
  task.view = json.at("view").get<int>();
  task.variant = json.at("variant").get<int>();
  task.reference = json.at("reference").get<int>();
  task.object = json.at("object").get<int>();
  task.resources.cores = json.at("resources").at("cores").get<int>();
  task.resources.gpu = json.at("resources").at("gpu").get<int>();
  task.resources.memory_mb = json.at("resources").at("memory_mb").get<int>();
  task.expected_seconds = json.at("expected_seconds").get<double>();
  task.timeout_seconds = json.at("timeout_seconds").get<double>();
  task.group = json.at("group").get<std::string>();
  task.refused = json.value("refused", "");
  return task;
}

}  // namespace

std::string plan_to_json(const Plan& plan) {
  Json json = {{"format", kPlanFormatVersion}, {"out", plan.out.string()}, {"gl", plan.gl}};
  json["job_file"] = std::filesystem::absolute(plan.job.file).string();
  json["job"] = Json::parse(job_text(plan.job));
  json["scene_hashes"] = plan.scene_hashes;
  json["tasks"] = Json::array();
  for (const auto& task : plan.tasks) json["tasks"].push_back(task_json(task, plan.tasks));
  return json.dump(1) + "\n";
}

Plan read_plan(const std::filesystem::path& file) try {
  const Json json = Json::parse(read_file(file));
  if (json.at("format").get<int>() != kPlanFormatVersion)
    throw Error("is a plan of another version of lightbench", file.string());
  Plan plan;
  plan.out = json.at("out").get<std::string>();
  plan.gl = json.at("gl").get<std::string>();
  plan.job = parse_job(json.at("job").dump(), json.at("job_file").get<std::string>());
  plan.scene_hashes = json.at("scene_hashes").get<std::vector<std::string>>();
  std::map<std::string, std::size_t> index;
  for (const auto& task : json.at("tasks")) {
    plan.tasks.push_back(task_of(task, index));
    index[plan.tasks.back().id] = plan.tasks.size() - 1;
  }
  return plan;
} catch (const nlohmann::json::exception& error) {
  throw Error(std::string("is not a plan: ") + error.what(), file.string());
} catch (const std::out_of_range&) {
  throw Error("is not a plan: a task needs one that is not there", file.string());
}

}  // namespace lightbench
