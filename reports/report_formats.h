#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "reports/run_report.h"

namespace lightbench {

struct ReportFile {
  std::string name;  ///< relative to the run's folder
  std::string text;
};

/// A way to write a run: one file pair in formats/ and one row in report_formats.cpp.
struct ReportFormat {
  std::string name;  ///< "html", "json", "junit", "markdown", "res", "svg"
  std::string doc;
  std::vector<ReportFile> (*write)(const RunReport& report) = nullptr;
};

std::span<const ReportFormat> report_formats();

/// Writes all formats (or only the named ones) into the run's folder; atomic per file.
void write_reports(const RunReport& report, const std::filesystem::path& folder,
                   const std::vector<std::string>& only = {});

/// The table that `lightbench run` prints at its end: per variant and reference the means of each metric.
std::string terminal_summary(const RunReport& report);

}  // namespace lightbench
