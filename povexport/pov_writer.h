#pragma once

#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lightbench {

/// Builds scene description text from our own words and from numbers; nothing else can get in. Numbers are
/// the shortest text that reads back to the same value, whatever the locale. NaN and infinity throw Error.
class PovWriter {
 public:
  /// Words of the language, in the source code of this program. (consteval: a name from a file does not
  /// compile.)
  struct Words {
    template <std::size_t N>
    consteval Words(const char (&literal)[N]) : text(literal, N - 1) {}  // NOLINT: implicit on purpose
    std::string_view text;
  };

  PovWriter& words(Words literal);
  PovWriter& number(float value);
  PovWriter& number(double value);
  PovWriter& integer(long long value);
  PovWriter& vector(const glm::vec2& v);  ///< <x,y>
  PovWriter& vector(const glm::vec3& v);  ///< <x,y,z>
  PovWriter& vector(const glm::dvec3& v);
  PovWriter& triple(const glm::uvec3& v);  ///< <i,j,k>
  /// An identifier: the literal followed by the number.
  PovWriter& name(Words prefix, long long number);
  /// A quoted file name that `pov_file_name` made.
  PovWriter& file(std::string_view file_name);
  PovWriter& append(const PovWriter& other);

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// "prefix_0007.extension": the only kind of file name that the text refers to.
std::string pov_file_name(PovWriter::Words prefix, int number, PovWriter::Words extension);

}  // namespace lightbench
