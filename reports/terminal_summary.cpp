#include <algorithm>

#include <fmt/format.h>

#include "reports/aligned_table.h"
#include "reports/ceiling.h"
#include "reports/escape.h"
#include "reports/object_tables.h"
#include "reports/reference_facts.h"
#include "reports/report_formats.h"
#include "reports/shared_warnings.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

constexpr std::size_t kListed = 10;

std::string mean_text(const RunReport& report, const std::string& metric, const std::string& variant,
                      const std::string& reference) {
  const MetricValue mean = mean_metric(report, metric, variant, reference).mean;
  return metric == "gain" ? gain_text(mean, mean_ceiling(report, reference))
                          : value_text(metric_or_plain(metric), mean);
}

/// How exact the references are, where it is known.
std::string reference_lines(const RunReport& report) {
  std::string text;
  for (const ReferenceFacts& facts : reference_facts(report))
    if (facts.noise)
      text += plain_line(fmt::format("noise of {}: {:.3f} of 255, at most {:.3f}", facts.name, *facts.noise,
                                     *facts.worst_noise)) +
              "\n";
  for (const std::string& line : light_share_lines(report)) text += plain_line(line) + "\n";
  for (const std::string& line : bounces_lines(report)) text += plain_line(line) + "\n";
  return text;
}

std::vector<std::string> summary_row(const RunReport& report, const std::string& variant,
                                     const std::string& reference, const std::string& leading) {
  const auto scores = worst_first(report, leading, variant, reference);
  const std::string mark = variant == report.baseline ? " (baseline)" : "";
  std::vector<std::string> row{name_cell(variant) + mark, name_cell(reference), measured_text(scores)};
  for (const std::string& name : report.metric_names)
    row.push_back(mean_text(report, name, variant, reference));
  if (leading.empty()) return row;
  const auto worst = std::ranges::find_if(
      scores, [&](const ReportScore* score) { return metric_of(*score, leading).value.has_value(); });
  row.push_back(worst == scores.end() ? "-"
                                      : value_text(metric_or_plain(leading), metric_of(**worst, leading)) +
                                            " " + name_cell((*worst)->scene + "/" + (*worst)->view));
  return row;
}

std::string first_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (std::size_t i = 0; i < std::min(lines.size(), kListed); ++i) text += plain_line(lines[i]) + "\n";
  if (lines.size() > kListed) text += fmt::format("... and {} more\n", lines.size() - kListed);
  return text;
}

std::string failure_lines(const RunReport& report) {
  std::vector<std::string> lines;
  for (const FailedTask& task : failed_tasks(report))
    lines.push_back(fmt::format("failed: {} {}: {}", task.where, task.what, task.error));
  return first_lines(lines);
}

std::string gate_lines(const RunReport& report) {
  std::string text;
  for (const ReportGate& gate : report.gates)
    text += fmt::format("gate {}: {}: {}\n",
                        gate.state == GateState::not_met      ? "NOT MET"
                        : gate.state == GateState::not_judged ? "NOT JUDGED"
                                                              : gate_state_text(gate.state),
                        plain_line(gate.text), plain_line(gate.detail));
  return text;
}

std::string warning_lines(const RunReport& report) {
  std::vector<std::string> lines;
  for (const SharedWarning& warning : shared_warnings(report)) {
    const std::string about = about_text(warning);
    lines.push_back("warning: " + warning.text + (about.empty() ? "" : " (" + about + ")"));
  }
  return first_lines(lines);
}

}  // namespace

std::string terminal_summary(const RunReport& report) {
  const std::string leading = leading_metric(report);
  TextTable table;
  std::vector<std::string> heading{"variant", "reference", "views"};
  for (const std::string& name : report.metric_names)
    heading.push_back(metric_heading(metric_or_plain(name)));
  if (!leading.empty()) heading.push_back("worst " + leading);
  table.push_back(heading);
  for (const ReportImageSource& variant : report.variants)
    for (const ReportImageSource& reference : report.references)
      table.push_back(summary_row(report, variant.name, reference.name, leading));
  return (table.size() > 1 ? aligned(table) : "") + reference_lines(report) +
         first_lines(object_lines(report)) + warning_lines(report) + gate_lines(report) +
         failure_lines(report) + plain_line(verdict_text(count_outcomes(report))) + "\n";
}

}  // namespace lightbench
