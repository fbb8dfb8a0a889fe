#include "reports/oracle_table.h"

#include <algorithm>
#include <iterator>
#include <span>

#include <fmt/format.h>

#include "reports/aligned_table.h"
#include "reports/ceiling.h"
#include "reports/escape.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

MetricValue gain_beside(const RunReport& report, const ReportScore& score, const std::string& variant) {
  const auto found = std::ranges::find_if(report.scores, [&](const ReportScore& other) {
    return other.variant == variant && other.reference == score.reference && other.scene == score.scene &&
           other.view == score.view;
  });
  return found == report.scores.end() ? MetricValue::undefined("it has no score") : metric_of(*found, "gain");
}

OracleRow mean_of(std::span<const OracleRow> rows) {
  OracleRow mean{"mean of " + counted(rows.size(), "view"), rows.front().variant};
  for (const OracleRow& row : rows) {
    mean.gain += row.gain / double(rows.size());
    mean.oracle += row.oracle / double(rows.size());
    mean.ceiling += row.ceiling / double(rows.size());
  }
  return mean;
}

const std::vector<std::string> kHeading{"view",
                                        "variant",
                                        "gain %",
                                        "oracle %",
                                        "ceiling %",
                                        "lost by searching",
                                        "lost since no picture holds it"};

std::vector<std::string> numbers(const OracleRow& row) {
  std::vector<std::string> cells;
  for (const double value : {row.gain, row.oracle, row.ceiling, row.lost_by_searching(), row.lost_unseen()})
    cells.push_back(fmt::format("{:.1f}", value));
  return cells;
}

/// All rows, with names made fit for where they stand.
template <typename Escape>
TextTable cells_of(const OracleTable& table, const Escape& escape) {
  TextTable cells{kHeading};
  for (const auto* rows : {&table.views, &table.means})
    for (const OracleRow& row : *rows) {
      cells.push_back({escape(row.view), escape(row.variant)});
      std::ranges::move(numbers(row), std::back_inserter(cells.back()));
    }
  return cells;
}

std::string left_out_line(const OracleTable& table) {
  return table.left_out == 0 ? ""
                             : fmt::format("Left out, since one of the three gains is not known: {}.\n",
                                           counted(table.left_out, "row"));
}

}  // namespace

OracleTable oracle_table(const RunReport& report, const std::vector<OraclePair>& pairs) {
  OracleTable table;
  for (const OraclePair& pair : pairs) {
    const std::size_t first = table.views.size();
    for (const ReportScore& score : report.scores) {
      if (score.variant != pair.variant || score.reference != report.primary_reference) continue;
      const MetricValue gain = metric_of(score, "gain");
      const MetricValue oracle = gain_beside(report, score, pair.oracle);
      const MetricValue ceiling = ceiling_of(report, score);
      if (gain.value && oracle.value && ceiling.value)
        table.views.push_back(
            {score.scene + "/" + score.view, pair.variant, *gain.value, *oracle.value, *ceiling.value});
      else
        ++table.left_out;
    }
    if (table.views.size() > first) table.means.push_back(mean_of(std::span(table.views).subspan(first)));
  }
  return table;
}

std::string oracle_text(const OracleTable& table) {
  return aligned(cells_of(table, name_cell)) + left_out_line(table);
}

std::string oracle_markdown(const OracleTable& table) {
  TextTable cells =
      cells_of(table, [](const std::string& text) { return escape_markdown(clean_utf8(text)); });
  cells.insert(cells.begin() + 1, {":--", ":--", "--:", "--:", "--:", "--:", "--:"});
  std::string text;
  for (const auto& row : cells) text += fmt::format("| {} |\n", fmt::join(row, " | "));
  return text + (table.left_out == 0 ? "" : "\n" + left_out_line(table));
}

}  // namespace lightbench
