#pragma once

#include <functional>
#include <streambuf>
#include <string>
#include <utility>

namespace lightbench {

/// What a stream reads whose lines are made one at a time, each when the one before has been read.
class LineFeed : public std::streambuf {
 public:
  /// `next` makes the next line, with its line feed; false: there is none.
  explicit LineFeed(std::function<bool(std::string&)> next) : next_(std::move(next)) {}

 private:
  int_type underflow() override {
    if (!next_(line_)) return traits_type::eof();
    setg(line_.data(), line_.data(), line_.data() + line_.size());
    return traits_type::to_int_type(line_[0]);
  }

  std::function<bool(std::string&)> next_;
  std::string line_;
};

}  // namespace lightbench
