#include "reports/formats/res.h"

#include <fmt/format.h>

#include "base/files.h"

namespace lightbench {
namespace {

using View = std::pair<std::string, std::string>;
using ScoresByView = std::map<View, const ReportScore*>;

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.10g}", *value) : "undefined";
}

/// One metric of baseline and variant, with its running means.
struct Column {
  std::string metric;
  double sum0 = 0, sum1 = 0;
  std::size_t count = 0;

  std::pair<std::optional<double>, std::optional<double>> add(const ReportScore* baseline,
                                                              const ReportScore& variant) {
    const auto value0 = baseline ? metric_of(*baseline, metric).value : std::nullopt;
    const auto value1 = metric_of(variant, metric).value;
    if (value0 && value1) {
      sum0 += *value0;
      sum1 += *value1;
      ++count;
    }
    return {value0, value1};
  }

  std::string means() const {
    if (count == 0) return "undefined vs. undefined\n";
    return fmt::format("{} vs. {}\n", number(sum0 / double(count)), number(sum1 / double(count)));
  }
};

ScoresByView scores_of(const RunReport& report, const std::string& variant) {
  ScoresByView scores;
  for (const ReportScore& score : report.scores)
    if (score.variant == variant && score.reference == report.primary_reference)
      scores[{score.scene, score.view}] = &score;
  return scores;
}

std::string lines(const RunReport& report, const std::string& variant, const ScoresByView& baseline) {
  Column correlation{.metric = "pearson"}, error{.metric = "mean_error"};
  std::string text;
  for (const ReportScore& score : report.scores) {
    if (score.variant != variant || score.reference != report.primary_reference) continue;
    const auto found = baseline.find({score.scene, score.view});
    const ReportScore* before = found == baseline.end() ? nullptr : found->second;
    const auto [c0, c1] = correlation.add(before, score);
    const auto [m0, m1] = error.add(before, score);
    text += fmt::format("{}/{} {} {}\t{} {}\tc:{}\tm:{}\n", escape_file_name(score.scene),
                        escape_file_name(score.view), number(c0), number(m0), number(c1), number(m1),
                        c0 && c1 && *c1 > *c0 ? "OK" : "failed", m0 && m1 && *m1 < *m0 ? "OK" : "failed");
  }
  return text + correlation.means() + error.means();
}

}  // namespace

std::string res_file(const std::string& variant) {
  return "res-" + escape_file_name(variant) + ".txt";
}

std::vector<ReportFile> write_res(const RunReport& report) {
  std::vector<ReportFile> files;
  if (report.baseline.empty()) return files;
  const ScoresByView baseline = scores_of(report, report.baseline);
  for (const ReportImageSource& variant : report.variants)
    if (variant.name != report.baseline)
      files.push_back({res_file(variant.name), lines(report, variant.name, baseline)});
  if (files.size() == 1) files.front().name = "res.txt";
  return files;
}

}  // namespace lightbench
