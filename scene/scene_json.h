#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "base/json_reader.h"
#include "scene/problem_list.h"
#include "scene/scene.h"

/// The values that scene files are made of. All of these throw Error with the JSON path.
namespace lightbench {

/// The largest coordinate, so that 32-bit floats can square it.
inline constexpr double kLargestCoordinate = 1e15;
/// Three numbers of at most kLargestCoordinate.
glm::vec3 read_point(const JsonValue& value);
/// The same, and not zero; returned with length 1.
glm::vec3 read_direction(const JsonValue& value);
/// Three numbers of 0 or more.
glm::vec3 read_color(const JsonValue& value);

/// {"translate", "rotate", "scale"} or {"matrix"}; affine and not singular.
glm::dmat4 read_transform(const JsonValue& value);

/// The most bytes of a name; tables show it and files are named after it.
inline constexpr std::size_t kMaxNameBytes = 200;
/// What keeps a text from being a name of at most `most` bytes ("must not be empty"), or nothing.
std::string name_problem(const std::string& name, std::size_t most = kMaxNameBytes);
/// A name: not empty, no control characters, at most `most` bytes.
std::string read_name(const JsonValue& value, std::size_t most = kMaxNameBytes);

inline constexpr double kLargestTime = 1e6;  ///< seconds
double read_time(const JsonValue& value);    ///< seconds, at most kLargestTime

/// One of a list of keyframes; the caller reads the other keys and finishes the object.
struct Keyframe {
  double time;
  JsonObject object;
};
/// At least two, their times rising strictly.
std::vector<Keyframe> read_keyframes(const JsonValue& list);
/// [{"time", "translate", "rotate", "scale"}, ...]; what a keyframe does not say is 0, 0 and 1.
std::vector<MotionKey> read_motion(const JsonValue& list);

Credit read_credit(const JsonValue& value);

/// What a material of a scene file says; the rest stays as it was.
struct MaterialPatch {
  std::optional<glm::vec3> diffuse;
  std::optional<float> specular;
  std::optional<float> exponent;
  std::optional<glm::vec3> emission;
  std::optional<float> reflectance;

  void apply(Material& material) const;
};

/// Reads the keys of an object one by one; a key that is wrong becomes a problem, and the others are still
/// read.
class KeyReader {
 public:
  KeyReader(const JsonValue& value, ProblemList& problems) : object_(value), problems_(problems) {}

  void required(const std::string& key, const std::function<void(const JsonValue&)>& read);
  void optional(const std::string& key, const std::function<void(const JsonValue&)>& read);
  bool has(const std::string& key) const { return object_.has(key); }
  void fail(const std::string& what) { problems_.error(what, object_.value().where()); }
  std::string where() const { return object_.value().where(); }
  /// Every key that was not asked for is a problem.
  void finish();

 private:
  JsonObject object_;
  ProblemList& problems_;
};

MaterialPatch read_material_patch(const JsonValue& value, ProblemList& problems);

}  // namespace lightbench
