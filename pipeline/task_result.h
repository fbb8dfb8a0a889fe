#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "reports/run_report.h"

namespace lightbench {

/// What a task that was done has to tell.
struct TaskResult {
  double seconds = 0;                          ///< wall clock
  double cpu_seconds = 0;                      ///< of an image or object: of all that made it
  std::map<std::string, std::string> outputs;  ///< file relative to the run's folder -> hash of its bytes
  std::map<std::string, std::string> inputs;   ///< likewise: what it read of other tasks' outputs
  std::vector<PassSeconds> passes;             ///< of a snapshot
  std::vector<std::string> warnings;
  std::map<std::string, MetricValue> metrics;  ///< of a score; of an object: ReportObject::numbers
  std::optional<double> noise;                 ///< of a reference or bake: its estimated mean error, of 255
  std::optional<double> mean_luminance;        ///< of a reference: of its object pixels, linear
  std::map<std::string, double> ray_rates;     ///< of what is path-traced: rays a second, by class
};

nlohmann::ordered_json to_json(const TaskResult& result);
/// Throws Error(..., where) when it is not what `to_json` made.
TaskResult task_result_from_json(const nlohmann::ordered_json& json, const std::string& where);

}  // namespace lightbench
