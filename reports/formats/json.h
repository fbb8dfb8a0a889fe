#pragma once

#include "reports/report_formats.h"

namespace lightbench {

/// run.json: the whole model (jobs/run.schema.json).
std::vector<ReportFile> write_json(const RunReport& report);

}  // namespace lightbench
