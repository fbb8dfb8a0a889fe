#pragma once

#include <string>

#include "reports/run_report.h"

/// The ceiling of a view: the gain of a path-traced image with as many bounces as the reference has. It is
/// what is left to win for techniques, since no image can be nearer to the reference than by the noise of
/// both.
namespace lightbench {

/// Returns the variant that gives the ceiling against a reference: the first offline one without limits that
/// has as many bounces and, if the reference is path-traced too, another seed; null if the run has none.
const ReportImageSource* ceiling_variant(const RunReport& report, const std::string& reference);

/// The ceiling on the view of a score, against its reference.
MetricValue ceiling_of(const RunReport& report, const ReportScore& score);

/// The mean ceiling over all views, or those of one scene.
MetricValue mean_ceiling(const RunReport& report, const std::string& reference,
                         const std::string& scene = "");

/// A gain beside its ceiling, "45.90 / 96.12"; the gain alone where there is no ceiling, and for the variant
/// that gives it.
std::string gain_text(const MetricValue& gain, const MetricValue& ceiling);

}  // namespace lightbench
