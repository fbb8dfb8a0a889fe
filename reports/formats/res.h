#pragma once

#include "reports/report_formats.h"

namespace lightbench {

/// The line format of the Image-space radiosity thesis, appendix E, against the primary reference:
///
///     NAME c0 m0<TAB>c1 m1<TAB>c:OK|failed<TAB>m:OK|failed
///
/// with the Pearson correlation c and mean error m of the baseline (0) and the variant (1); OK where c1 > c0
/// and m1 < m0. Two lines of means follow, "c0 vs. c1" and "m0 vs. m1". NAME is scene/view, escaped to have
/// no blanks.
///
/// A value that a failed task or an undefined metric leaves open reads "undefined"; its verdict is "failed",
/// and its line does not count in that value's means. res.txt where there is one variant besides the
/// baseline, else res-<variant>.txt for each; nothing where the run has no baseline.
std::vector<ReportFile> write_res(const RunReport& report);

/// The name of a variant's file where there are several.
std::string res_file(const std::string& variant);

}  // namespace lightbench
