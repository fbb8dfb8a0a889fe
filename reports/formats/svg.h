#pragma once

#include "reports/report_formats.h"

namespace lightbench {

/// cost.svg: reports/cost_chart.h, where the run has enough for it.
std::vector<ReportFile> write_svg(const RunReport& report);

}  // namespace lightbench
