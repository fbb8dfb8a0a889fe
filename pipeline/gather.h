#pragma once

#include <string>
#include <vector>

#include "base/exit_code.h"
#include "pipeline/executor.h"
#include "pipeline/plan.h"
#include "reports/run_report.h"

namespace lightbench {

/// The model of a run from how its tasks ended: every image and score of the plan stands in it exactly once.
/// In a part of a run (`selected` is not empty) a gate is judged by the scores that are there; one without
/// any is left out, with a warning. In a whole run a gate that lacks a score is not met.
RunReport gather_report(const Plan& plan, const PlanFacts& facts, const std::vector<TaskOutcome>& outcomes,
                        const std::vector<bool>& selected);

/// task_failed where something failed, or was not finished though it was asked for; else gate_failed where a
/// gate was not met; else ok.
ExitCode exit_code_of(const RunReport& report, const std::vector<TaskOutcome>& outcomes,
                      const std::vector<bool>& selected);
/// The same from a stored report.
ExitCode exit_code_of(const RunReport& report);

}  // namespace lightbench
