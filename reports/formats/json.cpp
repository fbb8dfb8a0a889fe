#include "reports/formats/json.h"

namespace lightbench {

std::vector<ReportFile> write_json(const RunReport& report) {
  return {{"run.json", run_report_to_json(report)}};
}

}  // namespace lightbench
