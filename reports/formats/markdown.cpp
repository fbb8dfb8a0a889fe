#include "reports/formats/markdown.h"

#include <algorithm>

#include <fmt/format.h>

#include "reports/ceiling.h"
#include "reports/cost_chart.h"
#include "reports/escape.h"
#include "reports/object_tables.h"
#include "reports/reference_facts.h"
#include "reports/sequences.h"
#include "reports/shared_warnings.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

constexpr std::size_t kRows = 100;  ///< of any one table
constexpr std::size_t kWorstViews = 10;
constexpr std::size_t kMetrics = 16;
constexpr std::size_t kCell = 300;           ///< characters
constexpr std::size_t kObjectText = 100000;  ///< bytes after which no table of objects begins

std::string cell(const std::string& text) {
  return escape_markdown(shortened(clean_utf8(text), kCell));
}

std::string row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string more(std::size_t count) {
  return count > kRows ? fmt::format("\n… and {} more.\n", count - kRows) : "";
}

std::vector<Metric> shown_metrics(const RunReport& report) {
  std::vector<Metric> shown;
  for (const std::string& name : report.metric_names)
    if (shown.size() < kMetrics) shown.push_back(metric_or_plain(name));
  return shown;
}

std::string cpu_time_cell(const RunReport& report, const std::string& variant) {
  const double seconds = mean_cpu_seconds(report, variant);
  return seconds > 0 ? duration_text(seconds) : "-";
}

std::string means(const RunReport& report) {
  const std::vector<Metric> shown = shown_metrics(report);
  std::vector<std::string> heading{"variant", "reference", "views"}, rule{":--", ":--", "--:"};
  for (const Metric& metric : shown) {
    heading.push_back(cell(metric_heading(metric)));
    rule.push_back("--:");
  }
  const bool timed = std::ranges::any_of(
      report.variants, [&](const auto& variant) { return mean_cpu_seconds(report, variant.name) > 0; });
  if (timed) heading.emplace_back("CPU time"), rule.emplace_back("--:");
  std::string text = "### Means\n\n" + row(heading) + row(rule);
  std::size_t rows = 0;
  for (const ReportImageSource& variant : report.variants) {
    for (const ReportImageSource& reference : report.references) {
      if (++rows > kRows) continue;
      const auto scores = worst_first(report, "", variant.name, reference.name);
      std::vector<std::string> cells{cell(variant.name), cell(reference.name), measured_text(scores)};
      for (const Metric& metric : shown) {
        const MeanValue mean = mean_metric(report, metric.name, variant.name, reference.name);
        cells.push_back(metric.name == "gain" ? gain_text(mean.mean, mean_ceiling(report, reference.name))
                                              : value_text(metric, mean.mean));
        if (mean.undefined > 0 && mean.count > 0) cells.back() += fmt::format(" (of {})", mean.count);
      }
      if (timed) cells.push_back(cpu_time_cell(report, variant.name));
      text += row(cells);
    }
  }
  return text + more(rows) + "\n";
}

std::string gate_cell(GateState state) {
  const std::string text = gate_state_text(state);
  return state == GateState::met ? text : "**" + text + "**";
}

std::string gates(const RunReport& report) {
  if (report.gates.empty()) return "";
  std::string text = "### Gates\n\n" + row({"", "gate", "result"}) + row({":--", ":--", ":--"});
  std::vector<const ReportGate*> order;
  for (const ReportGate& gate : report.gates) order.push_back(&gate);
  std::stable_partition(order.begin(), order.end(),
                        [](const ReportGate* gate) { return gate->state != GateState::met; });
  for (std::size_t i = 0; i < std::min(order.size(), kRows); ++i)
    text += row({gate_cell(order[i]->state), cell(order[i]->text), cell(order[i]->detail)});
  return text + more(order.size()) + "\n";
}

std::string optional_cell(const std::optional<double>& value, double factor, int decimals) {
  return value ? fmt::format("{:.{}f}", factor * *value, decimals) : "-";
}

std::string references(const RunReport& report) {
  const std::vector<ReferenceFacts> all = reference_facts(report);
  std::string notes;
  for (const std::string& line : bounces_lines(report)) notes += cell(line) + "\n\n";
  if (std::ranges::none_of(all, [](const ReferenceFacts& f) { return f.noise || f.light_share; }))
    return notes;
  std::string text =
      "### How exact the references are\n\n" +
      row({"reference", "kind", "bounces", "noise of 255", "worst noise", "light %", "seconds a view"}) +
      row({":--", ":--", "--:", "--:", "--:", "--:", "--:"});
  for (const ReferenceFacts& facts : all)
    text += row({cell(facts.name), cell(facts.kind), std::to_string(facts.bounces),
                 optional_cell(facts.noise, 1, 3), optional_cell(facts.worst_noise, 1, 3),
                 optional_cell(facts.light_share, 100, 1), fmt::format("{:.1f}", facts.seconds)});
  return text + "\n" + notes;
}

std::string sequences(const RunReport& report) {
  const std::vector<SequenceFacts> all = sequence_facts(report);
  if (all.empty()) return "";
  const Metric error = metric_or_plain("mean_error"), flicker = metric_or_plain("flicker");
  std::string text =
      "### Sequences\n\n" +
      row({"sequence", "variant", "reference", "frames", cell("mean_error"), "flicker", "worst", "in"}) +
      row({":--", ":--", ":--", "--:", "--:", "--:", "--:", ":--"});
  for (std::size_t i = 0; i < std::min(all.size(), kRows); ++i) {
    const SequenceFacts& facts = all[i];
    text += row({cell(facts.sequence->scene + "/" + facts.sequence->name), cell(facts.variant),
                 cell(facts.reference), std::to_string(facts.sequence->frames.size()),
                 value_text(error, facts.mean_error), value_text(flicker, facts.flicker),
                 value_text(flicker, facts.worst_flicker), cell(facts.worst_view)});
  }
  return text + more(all.size()) + "\n";
}

std::string object_row(const ObjectTable& table, const ObjectRow& object) {
  std::vector<std::string> cells{cell(object.object)};
  if (object.problem.empty()) {
    cells.insert(cells.end(), object.cells.begin(), object.cells.end());
  } else {
    cells.push_back(cell(object.problem));
    cells.resize(1 + table.columns.size());
  }
  return row(cells);
}

std::string object_table(const ObjectTable& table) {
  std::vector<std::string> heading{"object"}, rule{":--"};
  for (const ObjectColumn& column : table.columns) {
    heading.push_back(cell(column.heading));
    rule.emplace_back("--:");
  }
  std::string text =
      fmt::format("**{}** in {}\n\n", cell(table.variants), cell(table.scene)) + row(heading) + row(rule);
  for (std::size_t i = 0; i < std::min(table.rows.size(), kRows); ++i)
    text += object_row(table, table.rows[i]);
  return text + object_row(table, table.whole) + more(table.rows.size()) + "\n";
}

std::string objects(const char* title, const std::vector<ObjectTable>& tables, const char* note) {
  std::string text;
  std::size_t shown = 0;
  for (; shown < tables.size() && text.size() < kObjectText; ++shown) text += object_table(tables[shown]);
  if (shown < tables.size()) text += fmt::format("… and {} more tables.\n\n", tables.size() - shown);
  return tables.empty() ? "" : fmt::format("### {}\n\n{}{}\n\n", title, text, note);
}

std::string worst_views(const RunReport& report) {
  const std::string leading = leading_metric(report);
  if (leading.empty()) return "";
  const Metric metric = metric_or_plain(leading);
  std::string text;
  for (const ReportImageSource& variant : report.variants) {
    if (variant.name == report.baseline || text.size() > 100000) continue;
    const auto scores = worst_first(report, leading, variant.name, report.primary_reference);
    std::string list;
    std::size_t shown = 0;
    for (const ReportScore* score : scores) {
      const MetricValue value = metric_of(*score, leading);
      if (!value.value || shown == kWorstViews) continue;
      list += fmt::format("{}{} {}", shown++ == 0 ? "" : ", ", cell(score->scene + "/" + score->view),
                          value_text(metric, value));
    }
    if (shown > 0) text += fmt::format("- {}: {}\n", cell(variant.name), list);
  }
  return text.empty() ? "" : fmt::format("### Worst views by {}\n\n{}\n", cell(metric_heading(metric)), text);
}

std::string failures(const RunReport& report) {
  const std::vector<FailedTask> failed = failed_tasks(report);
  if (failed.empty()) return "";
  std::string text = "### Failed\n\n" + row({"view", "task", "error"}) + row({":--", ":--", ":--"});
  for (std::size_t i = 0; i < std::min(failed.size(), kRows); ++i)
    text += row({cell(failed[i].where), cell(failed[i].what), cell(failed[i].error)});
  return text + more(failed.size()) + "\n";
}

std::string warnings(const RunReport& report) {
  const std::vector<SharedWarning> all = shared_warnings(report);
  if (all.empty()) return "";
  std::string text = "### Warnings\n\n" + row({"about", "warning"}) + row({":--", ":--"});
  for (std::size_t i = 0; i < std::min(all.size(), kRows); ++i)
    text += row({cell(about_text(all[i])), cell(all[i].text)});
  return text + more(all.size()) + "\n";
}

}  // namespace

std::vector<ReportFile> write_markdown(const RunReport& report) {
  const RunCounts counts = count_outcomes(report);
  std::string text = fmt::format("## {}: {}\n\n", cell(report.job), verdict_text(counts));
  text += fmt::format("{} of {}x{}", counted(counts.views, "view"), report.width, report.height);
  if (!report.baseline.empty()) text += ", baseline " + cell(report.baseline);
  text += fmt::format(", {}.\n\n", duration_text(report.seconds));
  text += failures(report) + gates(report) + means(report) + sequences(report) + references(report) +
          objects("Baked objects", bake_tables(report), kBakeNote) +
          objects("Compressed objects", compression_tables(report), kCompressionNote) + worst_views(report) +
          warnings(report);
  return {{"summary.md", text}};
}

}  // namespace lightbench
