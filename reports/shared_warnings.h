#pragma once

#include <string>
#include <vector>

#include "reports/run_report.h"

namespace lightbench {

/// A warning and all that it is about.
struct SharedWarning {
  std::string text;
  std::vector<std::string> about;  ///< "cornell/front isr", "cornell/front isr against povray"; none: the run
};

/// Returns each warning of the run, its scenes, pictures and scores once, in the order in which they first
/// occur.
std::vector<SharedWarning> shared_warnings(const RunReport& report);

/// "cornell/front isr, cornell/corner isr and 7 more"; empty where the warning is about the run.
std::string about_text(const SharedWarning& warning);

}  // namespace lightbench
