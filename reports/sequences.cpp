#include "reports/sequences.h"

#include <algorithm>

namespace lightbench {
namespace {

MetricValue frame_metric(const RunReport& report, const SequenceFacts& facts, const std::string& view,
                         const std::string& metric) {
  const auto found = std::ranges::find_if(report.scores, [&](const ReportScore& score) {
    return score.scene == facts.sequence->scene && score.view == view && score.variant == facts.variant &&
           score.reference == facts.reference;
  });
  return found == report.scores.end() ? MetricValue::undefined("it has no score") : metric_of(*found, metric);
}

MetricValue mean_of(const std::vector<MetricValue>& values) {
  double sum = 0;
  std::size_t count = 0;
  for (const MetricValue& value : values)
    if (value.value) sum += *value.value, ++count;
  return count == 0 ? MetricValue::undefined("no frame has a value") : MetricValue::of(sum / double(count));
}

void add_flicker(const RunReport& report, SequenceFacts& facts) {
  facts.worst_flicker = MetricValue::undefined("no frame has a value");
  for (const ReportFrame& frame : facts.sequence->frames) {
    const MetricValue& value =
        facts.by_frame.emplace_back(frame_metric(report, facts, frame.view, "flicker"));
    if (!value.value || (facts.worst_flicker.value && *value.value <= *facts.worst_flicker.value)) continue;
    facts.worst_flicker = value;
    facts.worst_view = frame.view;
  }
  facts.flicker = mean_of(facts.by_frame);
}

}  // namespace

std::vector<SequenceFacts> sequence_facts(const RunReport& report) {
  std::vector<SequenceFacts> all;
  for (const ReportSequence& sequence : report.sequences)
    for (const ReportImageSource& variant : report.variants)
      for (const ReportImageSource& reference : report.references) {
        SequenceFacts& facts = all.emplace_back();
        facts.sequence = &sequence;
        facts.variant = variant.name;
        facts.reference = reference.name;
        std::vector<MetricValue> errors;
        for (const ReportFrame& frame : sequence.frames)
          errors.push_back(frame_metric(report, facts, frame.view, "mean_error"));
        facts.mean_error = mean_of(errors);
        add_flicker(report, facts);
      }
  return all;
}

double frame_rate(const ReportSequence& sequence) {
  if (sequence.frames.size() < 2) return 0;
  const double seconds = sequence.frames.back().time - sequence.frames.front().time;
  return seconds > 0 ? double(sequence.frames.size() - 1) / seconds : 0;
}

}  // namespace lightbench
