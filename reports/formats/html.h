#pragma once

#include "reports/report_formats.h"

namespace lightbench {

/// index.html: one page that needs no server, no network and no other file than the run's pictures. Without
/// scripts it still shows every picture and number; with them it sorts, filters and compares pictures.
std::vector<ReportFile> write_html(const RunReport& report);

}  // namespace lightbench
