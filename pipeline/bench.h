#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/job.h"

namespace lightbench {

/// Median and spread of one pass's times, or of a whole frame's ("all passes"), in seconds.
struct BenchTime {
  std::string pass;
  double median = 0;
  double lower = 0;  ///< first quartile
  double upper = 0;  ///< third quartile
};

struct BenchRow {
  std::string scene;
  std::string view;
  std::string variant;
  std::vector<BenchTime> times;  ///< the whole frame first
};

/// Median and quartiles, interpolated between neighbours. Needs at least one value.
BenchTime summarize(const std::string& pass, std::vector<double> seconds);

/// Whether the variant has times that say something: not those of path tracing, which is not meant for real
/// time, nor of reading another engine's pictures.
bool is_timed(const JobVariant& variant);

/// Times every view with every variant in this process, which should be alone on the machine: per view two
/// frames of each variant to warm up, then `rounds` rounds in which the variants take turns. Nothing comes
/// from a cache but baked objects, which must be in the run's folder `out` (bake_job). Only timed variants.
/// `only`: of those whose scene/view/variant matches this pattern, or begins with it as a path; empty: all.
std::vector<BenchRow> bench_job(const Job& concrete, const std::filesystem::path& out, const std::string& gl,
                                int rounds, const std::string& only = "");

std::string bench_table(const std::vector<BenchRow>& rows);
/// Of each variant the mean over the views of its whole frame's median, and that in times of the first one's.
std::string bench_means(const std::vector<BenchRow>& rows);
std::string bench_json(const Job& job, const std::vector<BenchRow>& rows, int rounds,
                       const std::string& renderer);

}  // namespace lightbench
