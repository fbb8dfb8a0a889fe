#pragma once

#include <concepts>
#include <string>
#include <utility>
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

  bool has_errors() const { return errors_ > 0; }
  std::size_t errors() const { return errors_; }
  const std::vector<Problem>& all() const { return problems_; }

 private:
  std::vector<Problem> problems_;
  std::size_t errors_ = 0;
};

/// Problems of one kind in one file, of which a broken file may have a million: the first few are listed, the
/// rest is counted by `finish`, or when this object ends.
class RepeatedProblem {
 public:
  RepeatedProblem(ProblemList& list, Problem::Severity severity, std::string kind, std::string file);
  RepeatedProblem(const RepeatedProblem&) = delete;
  RepeatedProblem& operator=(const RepeatedProblem&) = delete;
  ~RepeatedProblem();

  void add(std::string what, std::string where);
  /// The same for a text that takes long to make: `make_text` is called only where the problem is listed.
  template <std::invocable MakeText>
  void add(const MakeText& make_text, std::string where) {
    add(lists_next() ? make_text() : std::string(), std::move(where));
  }
  /// Whether the next one is listed: else nobody sees its text and its place.
  bool lists_next() const { return count_ < kListed; }
  /// Counts what is not listed as one problem, and starts again.
  void finish();

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
