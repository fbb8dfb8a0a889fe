#pragma once

#include <exception>
#include <functional>
#include <streambuf>
#include <string>
#include <utility>

namespace lightbench {

/// What a stream reads whose lines are made one at a time, each when the one before has been read. A stream
/// swallows what its buffer throws: ask for it with `rethrow` when the stream has ended.
class LineFeed : public std::streambuf {
 public:
  /// `next` makes the next line, with its line feed; false: there is none.
  explicit LineFeed(std::function<bool(std::string&)> next) : next_(std::move(next)) {}

  /// Throws what `next` threw, if it did; the lines ended there.
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  int_type underflow() override {
    if (thrown_ || !make_next()) return traits_type::eof();
    setg(line_.data(), line_.data(), line_.data() + line_.size());
    return traits_type::to_int_type(line_[0]);
  }

  bool make_next() {
    try {
      return next_(line_);
    } catch (...) {
      thrown_ = std::current_exception();
      return false;
    }
  }

  std::function<bool(std::string&)> next_;
  std::exception_ptr thrown_;
  std::string line_;
};

}  // namespace lightbench
