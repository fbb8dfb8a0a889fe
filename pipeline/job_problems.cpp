#include "pipeline/job_problems.h"

#include <algorithm>

#include <fmt/format.h>

namespace lightbench {
namespace {

constexpr std::size_t kListed = 50;

/// A name in the message may have line breaks; each problem stays one line.
std::string line_of(const Problem& problem) {
  std::string line = (problem.where.empty() ? "" : problem.where + ": ") + problem.what;
  std::ranges::replace(line, '\n', ' ');
  return "\n  " + line;
}

}  // namespace

void throw_problems(const ProblemList& problems, const std::string& file) {
  const std::size_t count = problems.errors();
  if (count == 0) return;
  std::string text = count < kMostProblems ? fmt::format("{} problems:", count)
                                           : fmt::format("{} problems or more:", kMostProblems);
  std::size_t listed = 0;
  for (const Problem& problem : problems.all()) {
    if (problem.severity != Problem::Severity::error) continue;
    if (count == 1) throw Error(problem.what, problem.where);
    if (listed++ < kListed) text += line_of(problem);
  }
  if (count > kListed) text += fmt::format("\n  and {} more", count - kListed);
  throw Error(text, file);
}

}  // namespace lightbench
