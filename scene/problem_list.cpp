#include "scene/problem_list.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"

namespace lightbench {

void ProblemList::error(std::string what, std::string where) {
  add(Problem::Severity::error, std::move(what), std::move(where));
}
void ProblemList::warning(std::string what, std::string where) {
  add(Problem::Severity::warning, std::move(what), std::move(where));
}
void ProblemList::note(std::string what, std::string where) {
  add(Problem::Severity::note, std::move(what), std::move(where));
}
void ProblemList::add(Problem::Severity severity, std::string what, std::string where) {
  if (severity == Problem::Severity::error) ++errors_;
  problems_.push_back({severity, std::move(what), std::move(where)});
}
void ProblemList::add(const Error& error) {
  this->error(error.message(), error.where());
}

RepeatedProblem::RepeatedProblem(ProblemList& list, Problem::Severity severity, std::string kind,
                                 std::string file)
    : list_(list), severity_(severity), kind_(std::move(kind)), file_(std::move(file)) {}

RepeatedProblem::~RepeatedProblem() {
  finish();
}

void RepeatedProblem::finish() {
  if (count_ > kListed) list_.add(severity_, fmt::format("{} more {}", count_ - kListed, kind_), file_);
  count_ = 0;
}

void RepeatedProblem::add(std::string what, std::string where) {
  if (++count_ <= kListed) list_.add(severity_, std::move(what), std::move(where));
}

std::string counted_names(const std::string& plural, const std::vector<std::string>& names) {
  constexpr std::size_t kNamed = 4;
  if (names.size() == 1) return fmt::format("1 {} ({})", plural.substr(0, plural.size() - 1), names[0]);
  std::vector<std::string> head(names.begin(),
                                names.begin() + std::ptrdiff_t(std::min(names.size(), kNamed)));
  std::string last = names.size() > kNamed ? fmt::format("{} more", names.size() - kNamed) : head.back();
  if (names.size() <= kNamed) head.pop_back();
  return fmt::format("{} {} ({} and {})", names.size(), plural, join(head, ", "), last);
}

}  // namespace lightbench
