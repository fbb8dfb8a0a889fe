#include "scene/scene_json.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "base/text.h"
#include "scene/transform.h"

namespace lightbench {
namespace {

constexpr double kLargestColor = 1e6;

// A matrix whose volume is below this share of its columns' lengths is flat in 32-bit floats.
constexpr double kSmallestVolume = 1e-6;

float share_or_factor(const JsonValue& value, double max) {
  return float(value.number(0, max));
}

void check_not_singular(const JsonValue& value, const glm::dmat4& m) {
  const glm::dmat3 linear(m);
  const double lengths = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
  if (!(std::abs(glm::determinant(linear)) > kSmallestVolume * lengths) || !(lengths > 0))
    value.fail("the transform is singular: it makes the model flat");
}

glm::dmat4 read_matrix(const JsonValue& value) {
  const std::vector<double> rows = value.numbers(16);
  glm::dmat4 m;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      m[column][row] = rows[std::size_t(row) * 4 + std::size_t(column)];
  for (const double x : rows)
    if (std::abs(x) > kLargestCoordinate) value.fail(fmt::format("{} is too large", x));
  if (rows[12] != 0 || rows[13] != 0 || rows[14] != 0 || rows[15] != 1)
    value.fail("the last row of the matrix must be 0, 0, 0, 1");
  return m;
}

glm::dvec3 read_exact_point(const JsonValue& value) {
  const glm::dvec3 p = value.vec3();
  for (int k = 0; k < 3; ++k)
    if (std::abs(p[k]) > kLargestCoordinate) value.fail(fmt::format("{} is too large a coordinate", p[k]));
  return p;
}

glm::dvec3 read_scale(const JsonValue& value) {
  return value.is_number() ? glm::dvec3(value.number(-kLargestCoordinate, kLargestCoordinate))
                           : glm::dvec3(read_point(value));
}

}  // namespace

// Not inlined: where g++ 12 sees doubles rounded to floats and made doubles again, in a vector, it leaves out
// the rounding of the first two.
[[gnu::noinline]] glm::vec3 read_point(const JsonValue& value) {
  return glm::vec3(read_exact_point(value));
}

glm::vec3 read_direction(const JsonValue& value) {
  const glm::dvec3 d(read_point(value));
  if (!(glm::length(d) > 0)) value.fail("a direction must not be zero");
  return glm::vec3(glm::normalize(d));
}

glm::vec3 read_color(const JsonValue& value) {
  const glm::dvec3 c = value.vec3();
  for (int k = 0; k < 3; ++k)
    if (!(c[k] >= 0 && c[k] <= kLargestColor))
      value.fail(fmt::format("a colour must lie between 0 and {}, not {}", kLargestColor, c[k]));
  return glm::vec3(c);
}

glm::dmat4 read_transform(const JsonValue& value) {
  JsonObject object = value.object();
  glm::dmat4 m(1);
  if (const auto matrix = object.find("matrix")) {
    if (object.keys().size() > 1)
      value.fail("'matrix' stands alone: no translate, rotate or scale beside it");
    m = read_matrix(*matrix);
  } else {
    const auto translate = object.find("translate");
    const auto rotate = object.find("rotate");
    const auto scale = object.find("scale");
    object.finish();
    if (translate) m = glm::translate(m, read_exact_point(*translate));
    if (rotate) m = m * rotation_degrees(rotate->vec3());
    if (scale) m = glm::scale(m, read_scale(*scale));
  }
  check_not_singular(value, m);
  return m;
}

std::string name_problem(const std::string& name, std::size_t most) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (trimmed(name).empty()) return "must not be empty";
  if (name.size() > most) return fmt::format("must have at most {} bytes", most);
  return std::any_of(name.begin(), name.end(), is_control) ? "must not have control characters" : "";
}

std::string read_name(const JsonValue& value, std::size_t most) {
  std::string name = value.text();
  if (const std::string problem = name_problem(name, most); !problem.empty()) value.fail("a name " + problem);
  return name;
}

double read_time(const JsonValue& value) {
  return value.number(-kLargestTime, kLargestTime);
}

std::vector<Keyframe> read_keyframes(const JsonValue& list) {
  std::vector<Keyframe> keyframes;
  for (const JsonValue& item : list.items()) {
    JsonObject object = item.object();
    const JsonValue value = object.at("time");
    const double time = read_time(value);
    if (!keyframes.empty() && time <= keyframes.back().time)
      value.fail(
          fmt::format("the times of keyframes must rise: {} is not after {}", time, keyframes.back().time));
    keyframes.push_back({time, std::move(object)});
  }
  if (keyframes.size() < 2) list.fail("there must be at least two keyframes");
  return keyframes;
}

std::vector<MotionKey> read_motion(const JsonValue& list) {
  std::vector<MotionKey> keys;
  for (Keyframe& keyframe : read_keyframes(list)) {
    MotionKey key{.time = keyframe.time};
    if (const auto translate = keyframe.object.find("translate")) key.translate = read_point(*translate);
    if (const auto rotate = keyframe.object.find("rotate")) key.rotate = rotate->vec3();
    if (const auto scale = keyframe.object.find("scale")) key.scale = read_scale(*scale);
    keyframe.object.finish();
    if (glm::any(glm::equal(key.scale, glm::dvec3(0))))
      keyframe.object.fail("a scale of 0 makes the model flat");
    if (!keys.empty() && glm::sign(key.scale) != glm::sign(keys.back().scale))
      keyframe.object.fail("the scale changes its sign: on the way the model would be flat");
    keys.push_back(key);
  }
  return keys;
}

Credit read_credit(const JsonValue& value) {
  JsonObject object = value.object();
  Credit credit;
  credit.piece = object.at("piece").text();
  if (const auto creator = object.find("creator")) credit.creator = creator->text();
  if (const auto license = object.find("license")) credit.license = license->text();
  object.finish();
  return credit;
}

void MaterialPatch::apply(Material& material) const {
  material.diffuse = diffuse.value_or(material.diffuse);
  material.specular = specular.value_or(material.specular);
  material.exponent = exponent.value_or(material.exponent);
  material.emission = emission.value_or(material.emission);
  material.reflectance = reflectance.value_or(material.reflectance);
}

void KeyReader::required(const std::string& key, const std::function<void(const JsonValue&)>& read) {
  if (!object_.has(key)) fail(fmt::format("the key '{}' is missing", key));
  optional(key, read);
}

void KeyReader::optional(const std::string& key, const std::function<void(const JsonValue&)>& read) {
  try {
    if (const auto value = object_.find(key)) read(*value);
  } catch (const Error& error) {
    problems_.add(error);
  }
}

void KeyReader::finish() {
  RepeatedProblem unknown(problems_, Problem::Severity::error, "unknown keys", where());
  for (const std::string& key : object_.unknown())
    unknown.add([&] { return object_.unknown_key_text(key); }, where());
}

MaterialPatch read_material_patch(const JsonValue& value, ProblemList& problems) {
  KeyReader keys(value, problems);
  MaterialPatch patch;
  keys.optional("diffuse", [&](const JsonValue& v) { patch.diffuse = read_color(v); });
  keys.optional("specular", [&](const JsonValue& v) { patch.specular = share_or_factor(v, kLargestColor); });
  keys.optional("exponent", [&](const JsonValue& v) { patch.exponent = float(v.number(1, 1e5)); });
  keys.optional("emission", [&](const JsonValue& v) { patch.emission = read_color(v); });
  keys.optional("reflectance", [&](const JsonValue& v) { patch.reflectance = share_or_factor(v, 1); });
  keys.finish();
  return patch;
}

}  // namespace lightbench
