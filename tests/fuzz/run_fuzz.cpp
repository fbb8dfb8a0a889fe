#include "fuzz_input.h"
#include "pipeline/gather.h"
#include "reports/report_formats.h"

namespace lightbench::fuzz {

/// A run.json, and all reports that are written from it.
void fuzz_run(std::string_view bytes) {
  const RunReport report = run_report_from_json(std::string(bytes), "run.json");
  for (const ReportFormat& format : report_formats()) format.write(report);
  terminal_summary(report);
  exit_code_of(report);
  const std::string text = run_report_to_json(report);
  require(run_report_to_json(run_report_from_json(text, "again.json")) == text,
          "a run that reads back as another one");
}

}  // namespace lightbench::fuzz
