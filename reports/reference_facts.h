#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/run_report.h"

namespace lightbench {

/// How far a reference of a run can be trusted, over the views on which it was made.
struct ReferenceFacts {
  std::string name;
  std::string kind;
  int bounces = 0;
  std::size_t views = 0;
  std::optional<double> noise;  ///< mean of the estimated errors, of 255, of the views where it is known
  std::optional<double> worst_noise;  ///< the largest of them
  /// Luminance of its object pixels as a share of the same in the reference with the most bounces, mean over
  /// the views that have both; nothing for that one itself.
  std::optional<double> light_share;
  double seconds = 0;      ///< mean wall clock
  double cpu_seconds = 0;  ///< sum
};

std::vector<ReferenceFacts> reference_facts(const RunReport& report);

/// The reference with the most bounces, where another one has fewer; else null.
const ReportImageSource* fullest_reference(const RunReport& report);

/// "povray (2 bounces) has 93.1 % of the light of converged (16 bounces)"; one line for each reference that
/// has a share.
std::vector<std::string> light_share_lines(const RunReport& report);

/// "povray has 2 bounces of indirect light; other numbers: direct 0, isr 1"; one line for each reference that
/// some variants do not follow. Pictures of other engines do not tell how many they have.
std::vector<std::string> bounces_lines(const RunReport& report);

}  // namespace lightbench
