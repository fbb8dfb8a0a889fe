#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lightbench {

/// Walks over the lines of a text that may end in LF, CRLF or CR, like the parser does.
class LineScanner {
 public:
  explicit LineScanner(std::string_view text) : text_(text) {}

  /// The next line without its end, or nothing.
  std::optional<std::string_view> next();
  std::size_t line() const { return line_; }                   ///< of the last one, from 1
  bool ended_by_newline() const { return ended_by_newline_; }  ///< whether the last one has a line end

 private:
  std::string_view text_;
  std::size_t start_ = 0;
  std::size_t next_ = 0;
  std::size_t line_ = 0;
  bool ended_by_newline_ = true;
};

/// Takes the next word (separated by blanks or tabs) off the front of `rest`; empty at the end.
std::string_view take_word(std::string_view& rest);

/// Blanks and tabs taken off both ends.
std::string_view stripped(std::string_view text);

/// The text before a comment. A # begins one only where a word begins: old C libraries print 1.#IND for NaN.
std::string_view without_comment(std::string_view text);

/// ASCII letters in lower case; all other bytes as they are.
std::string lower_case(std::string_view text);

enum class NumberKind {
  finite,
  not_finite,  ///< nan, inf, 1e999, -1.#IND
  malformed,
};

/// What a word is as a number in the grammar of OBJ files.
NumberKind classify_number(std::string_view word);

/// The finite number of a word, or 0.
double number_of(std::string_view word);

}  // namespace lightbench
