#pragma once

#include <concepts>
#include <string>

#include "base/error.h"
#include "scene/problem_list.h"

/// A job is read to its end, whatever is wrong in it, so that its author sees all mistakes at once.
namespace lightbench {

/// More are not kept: a file may have a million.
inline constexpr std::size_t kMostProblems = 1000;

/// Reads a part, whose Error becomes one more problem. Returns whether none was found.
template <std::invocable Read>
bool collect(ProblemList& problems, const Read& read) {
  const std::size_t before = problems.errors();
  try {
    read();
  } catch (const Error& error) {
    if (before < kMostProblems) problems.add(error);
    return false;
  }
  return problems.errors() == before;
}

/// Throws Error where there are problems: the only one as it is, several as lines with their places.
void throw_problems(const ProblemList& problems, const std::string& file);

}  // namespace lightbench
