#include "reports/formats/html.h"

#include <fmt/format.h>

#include "reports/formats/html_parts.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

const char* verdict_class(const RunCounts& counts) {
  if (counts.gates_not_met > 0 || counts.failed > 0) return "bad";
  return counts.skipped > 0 || counts.gates_not_judged > 0 ? "warn" : "good";
}

std::string fact(const std::string& name, const std::string& value) {
  return value.empty() ? "" : fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, h(value));
}

std::string facts(const RunReport& report, const RunCounts& counts) {
  std::string size = fmt::format("{} × {}", report.width, report.height);
  if (report.samples > 1) size += fmt::format(", {0}×{0} samples", report.samples);
  return "<dl class=\"facts\">" + fact("Views", std::to_string(counts.views)) +
         fact("Variants", std::to_string(report.variants.size())) + fact("Size", size) +
         fact("Baseline", report.baseline) + fact("Reference", report.primary_reference) +
         fact("Started", report.started) + fact("Took", duration_text(report.seconds)) +
         fact("Job", report.job_file) + "</dl>";
}

std::string header(const RunReport& report) {
  const RunCounts counts = count_outcomes(report);
  return fmt::format(
      "<header class=\"top\"><div class=\"brand\">lightbench</div><h1>{}</h1>"
      "<p class=\"verdict {}\">{}</p>{}</header>\n",
      h(report.job), verdict_class(counts), h(verdict_text(counts)), facts(report, counts));
}

std::string navigation(const RunReport& report, bool problems) {
  std::string links = "<a href=\"#summary\">Summary</a>";
  if (!report.sequences.empty()) links += "<a href=\"#sequences\">Sequences</a>";
  if (!report.gates.empty()) links += "<a href=\"#gates\">Gates</a>";
  if (problems) links += "<a href=\"#problems\">Problems</a>";
  links += "<a href=\"#pictures\">Pictures</a>";
  if (!report.scores.empty()) links += "<a href=\"#scores\">Scores</a>";
  if (!report.bakes.empty() || !report.compressions.empty())
    links += "<a href=\"#objects\">Baked objects</a>";
  links += "<a href=\"#about\">About this run</a>";
  return "<nav>" + links + "</nav>\n";
}

}  // namespace

std::vector<ReportFile> write_html(const RunReport& report) {
  const ViewRows rows(report);
  const std::string problems = html_problems(report);
  std::string page = html_page_start(report.job);
  page += header(report) + navigation(report, !problems.empty()) + "<main>\n";
  page += html_summary(report, rows) + html_sequences(report, rows) + html_gates(report) + problems +
          html_pictures(report, rows) + html_scores(report, rows) + html_objects(report) + html_about(report);
  page += "</main>\n<script type=\"application/json\" id=\"run-data\">" + html_data(report, rows) +
          "</script>\n<script>\n" + kReportJs + "</script>\n</body>\n</html>\n";
  return {{"index.html", page}};
}

}  // namespace lightbench
