#pragma once

#include <string>
#include <vector>

#include "base/exit_code.h"
#include "pipeline/executor.h"
#include "pipeline/plan.h"
#include "reports/run_report.h"

namespace lightbench {

/// What gates are judged by.
enum class GateScope {
  all_scores,     ///< a gate that lacks one of its scores is not judged
  what_is_there,  ///< the scores that the run has decide; a gate without any is not judged
};

/// The model of a run from how its tasks ended: every image and score of the plan stands in it exactly once.
RunReport gather_report(const Plan& plan, const PlanFacts& facts, const std::vector<TaskOutcome>& outcomes,
                        GateScope scope);

/// task_failed where something that was asked for failed or was not finished; else gate_failed where a gate
/// was not met; else not_judged where one was not judged and the run is not a partial one; else ok.
ExitCode exit_code_of(const RunReport& report, const std::vector<TaskOutcome>& outcomes,
                      const std::vector<bool>& selected);
/// The same from a stored report, of which everything counts as asked for.
ExitCode exit_code_of(const RunReport& report);

}  // namespace lightbench
