#pragma once

#include <string>
#include <vector>

#include "pipeline/job.h"
#include "reports/oracle_table.h"

namespace lightbench {

struct OracleJob {
  Job job;                        ///< named `NAME-oracle`
  std::vector<OraclePair> pairs;  ///< in the order of its variants
};

/// The job with a variant `NAME, oracle` (technique isr_oracle) behind each variant of technique `isr` that
/// shows direct light too, with what it sees; variants that see the same share one. A path-traced variant
/// with the bounces of the primary reference is added where the job has none, and metric `gain`. Sweeps are
/// expanded. Gates are left out: they judge the job's own run. With `only`, other variants than those of
/// these names are left out, but for the baseline and what gives the ceiling. Throws Error where there is no
/// such variant, no reference, or no baseline.
OracleJob oracle_job(const Job& job, const std::vector<std::string>& only = {});

}  // namespace lightbench
