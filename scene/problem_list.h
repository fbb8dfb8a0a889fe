#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "scene/scene_file.h"

namespace lightbench {

/// What was found while reading a scene, in order.
class ProblemList {
 public:
  void error(std::string what, std::string where);
  void warning(std::string what, std::string where);
  void note(std::string what, std::string where);
  void add(Problem::Severity severity, std::string what, std::string where);
  void add(const Error& error);

  bool has_errors() const;
  const std::vector<Problem>& all() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// Problems of one kind in one file, of which a broken file may have a million: the first few are listed, the
/// rest is counted when this object ends.
class RepeatedProblem {
 public:
  RepeatedProblem(ProblemList& list, Problem::Severity severity, std::string kind, std::string file);
  RepeatedProblem(const RepeatedProblem&) = delete;
  RepeatedProblem& operator=(const RepeatedProblem&) = delete;
  ~RepeatedProblem();

  void add(std::string what, std::string where);
  std::size_t count() const { return count_; }

 private:
  static constexpr std::size_t kListed = 5;

  ProblemList& list_;
  Problem::Severity severity_;
  std::string kind_;  ///< plural: "faces with an index out of range"
  std::string file_;
  std::size_t count_ = 0;
};

/// "3 materials (a, b and c)", "140 materials (a, b, c, d and 136 more)".
std::string counted_names(const std::string& plural, const std::vector<std::string>& names);

}  // namespace lightbench
