#pragma once

#include <stdexcept>
#include <string>

namespace lightbench {

/// Bad input, a failing tool or a full disk: what is wrong, and where.
/// `where` is a file, `file:line`, `file: $.json.path`, a command line option, or empty.
/// Bugs are assertions and expected outcomes are values; neither is an Error.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& what, const std::string& where = "")
      : std::runtime_error(where.empty() ? what : where + ": " + what), message_(what), where_(where) {}

  const std::string& message() const { return message_; }
  const std::string& where() const { return where_; }

 private:
  std::string message_;
  std::string where_;
};

}  // namespace lightbench
