#include "povexport/pov_writer.h"

#include <cassert>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"

namespace lightbench {
namespace {

template <typename Number>
void append_number(std::string& text, Number value) {
  char buffer[64];
  const auto [end, code] = std::to_chars(buffer, buffer + sizeof buffer, value);
  assert(code == std::errc());
  text.append(buffer, end);
}

template <typename Real>
void append_real(std::string& text, Real value) {
  if (!std::isfinite(value)) throw Error("a number that is not finite cannot be exported to POV-Ray");
  append_number(text, value == 0 ? Real(0) : value);  // "-0" and "0" would make equal scenes differ
}

template <typename Vector>
void append_vector(std::string& text, const Vector& v) {
  for (int i = 0; i < Vector::length(); ++i) {
    text += i == 0 ? '<' : ',';
    append_real(text, v[i]);
  }
  text += '>';
}

}  // namespace

PovWriter& PovWriter::words(Words literal) {
  text_ += literal.text;
  return *this;
}

PovWriter& PovWriter::number(float value) {
  append_real(text_, value);
  return *this;
}

PovWriter& PovWriter::number(double value) {
  append_real(text_, value);
  return *this;
}

PovWriter& PovWriter::integer(long long value) {
  append_number(text_, value);
  return *this;
}

PovWriter& PovWriter::vector(const glm::vec2& v) {
  append_vector(text_, v);
  return *this;
}

PovWriter& PovWriter::vector(const glm::vec3& v) {
  append_vector(text_, v);
  return *this;
}

PovWriter& PovWriter::vector(const glm::dvec3& v) {
  append_vector(text_, v);
  return *this;
}

PovWriter& PovWriter::triple(const glm::uvec3& v) {
  for (int i = 0; i < 3; ++i) {
    text_ += i == 0 ? '<' : ',';
    append_number(text_, v[i]);
  }
  text_ += '>';
  return *this;
}

PovWriter& PovWriter::name(Words prefix, long long number) {
  return words(prefix).integer(number);
}

PovWriter& PovWriter::file(std::string_view file_name) {
  assert(file_name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789.") == std::string_view::npos);
  text_ += '"';
  text_ += file_name;
  text_ += '"';
  return *this;
}

PovWriter& PovWriter::append(const PovWriter& other) {
  text_ += other.text_;
  return *this;
}

std::string pov_file_name(PovWriter::Words prefix, int number, PovWriter::Words extension) {
  return fmt::format("{}_{:04}.{}", prefix.text, number, extension.text);
}

}  // namespace lightbench
