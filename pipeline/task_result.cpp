#include "pipeline/task_result.h"

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace lightbench {

nlohmann::ordered_json to_json(const TaskResult& result) {
  nlohmann::ordered_json json;
  json["seconds"] = result.seconds;
  json["outputs"] = nlohmann::ordered_json::object();
  for (const auto& [file, hash] : result.outputs) json["outputs"][file] = hash;
  for (const auto& [file, hash] : result.inputs) json["inputs"][file] = hash;
  if (!result.passes.empty()) json["passes"] = nlohmann::ordered_json::array();
  for (const auto& pass : result.passes)
    json["passes"].push_back({{"name", pass.name}, {"seconds", pass.seconds}});
  if (!result.warnings.empty()) json["warnings"] = result.warnings;
  for (const auto& [name, metric] : result.metrics)
    if (metric.value)
      json["metrics"][name] = *metric.value;
    else
      json["metrics"][name] = {{"undefined", metric.undefined_because}};
  if (result.cpu_seconds > 0) json["cpu_seconds"] = result.cpu_seconds;
  if (result.noise) json["noise"] = *result.noise;
  if (result.mean_luminance) json["mean_luminance"] = *result.mean_luminance;
  if (!result.ray_rates.empty()) json["ray_rates"] = result.ray_rates;
  return json;
}

TaskResult task_result_from_json(const nlohmann::ordered_json& json, const std::string& where) try {
  TaskResult result;
  result.seconds = json.at("seconds").get<double>();
  result.outputs = json.at("outputs").get<std::map<std::string, std::string>>();
  if (json.contains("inputs")) result.inputs = json.at("inputs").get<std::map<std::string, std::string>>();
  if (json.contains("passes"))
    for (const auto& pass : json.at("passes"))
      result.passes.push_back({pass.at("name").get<std::string>(), pass.at("seconds").get<double>()});
  if (json.contains("warnings")) result.warnings = json.at("warnings").get<std::vector<std::string>>();
  if (json.contains("metrics"))
    for (const auto& [name, value] : json.at("metrics").items())
      result.metrics[name] = value.is_number()
                                 ? MetricValue::of(value.get<double>())
                                 : MetricValue::undefined(value.at("undefined").get<std::string>());
  result.cpu_seconds = json.value("cpu_seconds", 0.0);
  if (json.contains("noise")) result.noise = json.at("noise").get<double>();
  if (json.contains("mean_luminance")) result.mean_luminance = json.at("mean_luminance").get<double>();
  if (json.contains("ray_rates"))
    result.ray_rates = json.at("ray_rates").get<std::map<std::string, double>>();
  return result;
} catch (const nlohmann::json::exception& error) {
  throw Error(std::string("not the result of a task: ") + error.what(), where);
}

}  // namespace lightbench
