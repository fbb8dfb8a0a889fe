#pragma once

#include <string>
#include <vector>

#include "reports/run_report.h"

/// Where a screen-space variant's gain is lost: between it and its oracle, which gathers from the same
/// pictures by exact rays, by searching; between the oracle and the ceiling, since no picture holds the
/// surface. All are gains against the primary reference, in percent.
namespace lightbench {

/// A variant and its oracle, by name.
struct OraclePair {
  std::string variant;
  std::string oracle;

  bool operator==(const OraclePair&) const = default;
};

struct OracleRow {
  std::string view;  ///< "scene/view", or how many the row is the mean of
  std::string variant;
  double gain = 0;
  double oracle = 0;
  double ceiling = 0;

  double lost_by_searching() const { return oracle - gain; }
  double lost_unseen() const { return ceiling - oracle; }
};

struct OracleTable {
  std::vector<OracleRow> views;  ///< by pair, in the order of the run's scores
  std::vector<OracleRow> means;  ///< over the views of each pair that has any
  std::size_t left_out = 0;      ///< views of a pair on which one of the three gains is not known
};
OracleTable oracle_table(const RunReport& report, const std::vector<OraclePair>& pairs);

/// For a terminal, and the same as a Markdown document.
std::string oracle_text(const OracleTable& table);
std::string oracle_markdown(const OracleTable& table);

}  // namespace lightbench
