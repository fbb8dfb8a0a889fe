#pragma once

#include "reports/report_formats.h"

namespace lightbench {

/// junit.xml: one suite of gates, one of images and one of scores; a gate that is not met is a failure, a
/// task that failed an error. Times are those of an ordinary run.
std::vector<ReportFile> write_junit(const RunReport& report);

}  // namespace lightbench
