#include "reports/formats/svg.h"

#include "reports/cost_chart.h"

namespace lightbench {

std::vector<ReportFile> write_svg(const RunReport& report) {
  const std::string chart = cost_chart(report);
  if (chart.empty()) return {};
  return {{"cost.svg", chart}};
}

}  // namespace lightbench
