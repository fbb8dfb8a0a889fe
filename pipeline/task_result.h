#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "reports/run_report.h"

namespace lightbench {

/// What a task that was done has to tell.
struct TaskResult {
  double seconds = 0;                          ///< wall clock
  std::map<std::string, std::string> outputs;  ///< file relative to the run's folder -> hash of its bytes
  std::vector<PassSeconds> passes;             ///< of a snapshot
  std::vector<std::string> warnings;
  std::map<std::string, MetricValue> metrics;  ///< of a score
};

nlohmann::ordered_json to_json(const TaskResult& result);
/// Throws Error(..., where) when it is not what `to_json` made.
TaskResult task_result_from_json(const nlohmann::ordered_json& json, const std::string& where);

}  // namespace lightbench
