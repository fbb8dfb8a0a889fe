#include "reports/report_formats.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "reports/formats/html.h"
#include "reports/formats/json.h"
#include "reports/formats/junit.h"
#include "reports/formats/markdown.h"
#include "reports/formats/res.h"
#include "reports/formats/svg.h"

namespace lightbench {
namespace {

const ReportFormat& find_format(const std::string& name) {
  std::vector<std::string> known;
  for (const ReportFormat& format : report_formats()) {
    if (format.name == name) return format;
    known.push_back(format.name);
  }
  throw Error("unknown report format '" + name + "'" + did_you_mean(name, known));
}

}  // namespace

std::span<const ReportFormat> report_formats() {
  static const ReportFormat table[] = {
      {"html", "index.html: pictures and scores, opened by double-click", write_html},
      {"json", "run.json: everything, as jobs/run.schema.json describes it", write_json},
      {"junit", "junit.xml: gates and tasks as test cases", write_junit},
      {"markdown", "summary.md: means, gates and worst views for a CI step's summary", write_markdown},
      {"res", "res.txt: correlation and mean error of baseline and variant, a line for each view", write_res},
      {"svg", "cost.svg: the variants' gain over the processor time that a picture takes them", write_svg},
  };
  return table;
}

void write_reports(const RunReport& report, const std::filesystem::path& folder,
                   const std::vector<std::string>& only) {
  std::vector<const ReportFormat*> chosen;
  chosen.reserve(only.size());
  for (const std::string& name : only) chosen.push_back(&find_format(name));
  if (only.empty())
    for (const ReportFormat& format : report_formats()) chosen.push_back(&format);
  for (const ReportFormat* format : chosen)
    for (const ReportFile& file : format->write(report)) write_file_atomic(folder / file.name, file.text);
}

}  // namespace lightbench
