#pragma once

#include <string>
#include <vector>

#include "reports/run_report.h"

namespace lightbench {

/// What a variant comes to over the frames of a sequence, against one reference.
struct SequenceFacts {
  const ReportSequence* sequence = nullptr;  ///< of the report
  std::string variant;
  std::string reference;
  MetricValue mean_error;             ///< mean over the frames that have one
  MetricValue flicker;                ///< the same
  MetricValue worst_flicker;          ///< the largest
  std::string worst_view;             ///< where; empty where no frame has one
  std::vector<MetricValue> by_frame;  ///< flicker of each frame
};

/// In the order of sequences, variants and references; empty where the run has no sequences.
std::vector<SequenceFacts> sequence_facts(const RunReport& report);

/// Frames a second, by the times of the first and the last one; 0 where these do not tell.
double frame_rate(const ReportSequence& sequence);

}  // namespace lightbench
