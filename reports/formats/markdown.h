#pragma once

#include "reports/report_formats.h"

namespace lightbench {

/// summary.md for a CI step's summary, which is dropped whole above 1 MiB: means, gates, worst views and
/// failures, with long lists cut, so that it stays far below.
std::vector<ReportFile> write_markdown(const RunReport& report);

}  // namespace lightbench
