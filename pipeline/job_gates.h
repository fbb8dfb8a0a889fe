#pragma once

#include "base/json_reader.h"
#include "pipeline/job.h"
#include "scene/problem_list.h"

namespace lightbench {

/// Which lists of a job were read without a problem: only then is a name that stands in none of them one
/// more.
struct WholeLists {
  bool scenes = false;
  bool variants = false;
  bool references = false;
  bool metrics = false;
};

/// Adds the gates of a job whose other lists are read. What they name must be there, but for views: those are
/// known when the job is made concrete.
void read_gates(const JsonValue& list, const WholeLists& whole, ProblemList& problems, Job& job);

/// Finds gates whose pattern matches no view of the scenes that they are about, among those whose views are
/// known already.
void check_gate_views(const std::vector<Gate>& gates, const std::vector<JobScene>& scenes,
                      ProblemList& problems);

}  // namespace lightbench
