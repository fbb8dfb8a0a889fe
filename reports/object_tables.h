#pragma once

#include <string>
#include <vector>

#include "reports/run_report.h"

/// What baking the objects of a scene cost, and what compressing them costs and saves, as in the table of a
/// paper.
namespace lightbench {

struct ObjectColumn {
  std::string heading;
  std::string doc;
};

struct ObjectRow {
  std::string object;
  std::string problem;             ///< why there are no numbers; else empty
  std::vector<std::string> cells;  ///< one for each column; "-" where a number is not known
};

struct ObjectTable {
  std::string scene;
  std::string variants;  ///< the names of all that draw these objects
  std::vector<ObjectColumn> columns;
  std::vector<ObjectRow> rows;
  ObjectRow whole;  ///< the scene: sums, means and maxima over the objects that have numbers
};

/// One for each scene and the variants that share its objects' files, in the order of the run.
std::vector<ObjectTable> bake_tables(const RunReport& report);
std::vector<ObjectTable> compression_tables(const RunReport& report);

/// What a reader of the tables must know besides.
inline constexpr const char* kBakeNote =
    "Rates are for a second of processor time. A radiance sample is a texel in one direction.";
inline constexpr const char* kCompressionNote =
    "A value is a texel in one direction; its error, of 255, is the mean over its components. The mean error "
    "is that of the changed values alone. Of the whole scene, the 99 % is the worst object's. MB are "
    "millions of bytes.";

/// Each table as a line: "baked office (raw): 4 objects, 0.25 million texels of 400 directions, ...".
std::vector<std::string> object_lines(const RunReport& report);

}  // namespace lightbench
