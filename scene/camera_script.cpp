#include "scene/camera_script.h"

#include <optional>
#include <set>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "base/json_bytes.h"
#include "scene/motion.h"
#include "scene/scene_json.h"

namespace lightbench {

namespace {

constexpr int kLastFrame = 1000000;

// Degrees. Nearer to 0 and to 180 the size of the picture has no use in 32-bit floats, or is not even finite.
constexpr double kNarrowestFov = 0.001;
constexpr double kWidestFov = 179.9;

// A frame's name is its view's name and at most this many bytes more, such as ".000".
constexpr std::size_t kMaxFrameNameBytes = 10;

// The shortest text of a float, which reads back to the same float.
std::string number(float x) {
  return fmt::format("{}", x);
}

std::string array(const glm::vec3& v) {
  return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z));
}

float to_radians(double degrees) {
  return float(glm::radians(degrees));
}

// The shortest number of degrees that reads back to the same radians.
std::string degrees_text(float radians) {
  const double exact = glm::degrees(double(radians));
  for (int digits = 6; digits < 17; ++digits) {
    std::string text = fmt::format("{:.{}g}", exact, digits);
    if (to_radians(std::stod(text)) == radians) return text;
  }
  return fmt::format("{}", exact);
}

// What a view, or one of its keyframes, says of its camera.
struct CameraPatch {
  std::optional<glm::vec3> position;
  std::optional<glm::vec3> look_at;
  std::optional<glm::vec3> up;
  std::optional<float> fov;
};

// Keys that are not there are as in `defaults`.
CameraPatch read_patch(JsonObject& object, const CameraPatch& defaults = {}) {
  CameraPatch patch = defaults;
  if (const auto position = object.find("position")) patch.position = read_point(*position);
  if (const auto look_at = object.find("look_at")) patch.look_at = read_point(*look_at);
  if (const auto up = object.find("up")) patch.up = read_point(*up);
  if (const auto fov = object.find("fov")) {
    const double degrees = fov->number();
    if (!(degrees >= kNarrowestFov && degrees <= kWidestFov))
      fov->fail(
          fmt::format("fov must lie between {} and {} degrees, not {}", kNarrowestFov, kWidestFov, degrees));
    patch.fov = to_radians(degrees);
  }
  return patch;
}

Camera camera_of(const CameraPatch& patch, const JsonObject& object) {
  if (!patch.position) object.fail("the key 'position' is missing");
  if (!patch.look_at) object.fail("the key 'look_at' is missing");
  Camera camera;
  camera.position = *patch.position;
  camera.look_at = *patch.look_at;
  camera.up = patch.up.value_or(camera.up);
  camera.fov = patch.fov.value_or(camera.fov);
  const std::string problem = camera_problem(camera);
  if (!problem.empty()) object.fail(problem);
  return camera;
}

std::vector<CameraKey> read_camera_keys(const JsonValue& list, const CameraPatch& defaults) {
  std::vector<CameraKey> keys;
  for (Keyframe& keyframe : read_keyframes(list)) {
    const CameraPatch patch = read_patch(keyframe.object, defaults);
    keyframe.object.finish();
    keys.push_back({keyframe.time, camera_of(patch, keyframe.object)});
  }
  return keys;
}

SequenceFrame read_frame(JsonObject object) {
  SequenceFrame frame;
  frame.sequence = object.at("of").text();
  frame.number = int(object.at("number").integer(0, kLastFrame));
  object.finish();
  return frame;
}

// A script may come from a newer generator than is known here.
void check_drawn(JsonObject object) {
  object.at("seed").number(0);  // JSON holds no whole number beyond 2^53 exactly
  object.at("version").integer(1);
  object.finish();
}

std::string camera_text(const Camera& c) {
  return fmt::format("\"position\": {}, \"look_at\": {}, \"up\": {}, \"fov\": {}", array(c.position),
                     array(c.look_at), array(c.up), degrees_text(c.fov));
}

std::string quoted(const std::string& text) {
  return json_text(text);
}

std::string view_text(const View& view) {
  std::string text = fmt::format("    {{\"name\": {}, {}", quoted(view.name), camera_text(view.camera));
  if (view.time != 0) text += fmt::format(", \"time\": {}", view.time);
  if (view.frame)
    text += fmt::format(", \"frame\": {{\"of\": {}, \"number\": {}}}", quoted(view.frame->sequence),
                        view.frame->number);
  const char* separator = ", \"keyframes\": [";
  for (const CameraKey& key : view.keyframes) {
    text += fmt::format("{}\n      {{\"time\": {}, {}}}", separator, key.time, camera_text(key.camera));
    separator = ",";
  }
  return text + (view.keyframes.empty() ? "}" : "]}");
}

}  // namespace

View read_view(const JsonValue& value) {
  JsonObject object = value.object();
  View view;
  view.where = value.where();
  const JsonValue name = object.at("name");
  const CameraPatch patch = read_patch(object);
  if (const auto time = object.find("time")) view.time = read_time(*time);
  if (const auto frame = object.find("frame")) view.frame = read_frame(frame->object());
  view.name = read_name(name, kMaxNameBytes + (view.frame ? kMaxFrameNameBytes : 0));
  const auto keyframes = object.find("keyframes");
  object.finish();
  if (!keyframes) {
    view.camera = camera_of(patch, object);
    return view;
  }
  view.keyframes = read_camera_keys(*keyframes, patch);
  return view_at(view, view.time);
}

std::vector<View> read_camera_script(const std::filesystem::path& file) {
  JsonObject object = JsonValue::parse_file(file).object();
  const JsonValue list = object.at("views");
  if (const auto drawn = object.find("drawn")) check_drawn(drawn->object());
  object.finish();
  std::vector<View> views;
  std::set<std::string> names;
  for (const JsonValue& item : list.items()) {
    views.push_back(read_view(item));
    if (!names.insert(views.back().name).second)
      item.fail(fmt::format("a second view named '{}'", views.back().name));
  }
  if (views.empty()) list.fail("the camera script has no views");
  return views;
}

std::string camera_script_text(const std::vector<View>& views, const std::optional<DrawnBy>& drawn) {
  std::string text = "{\n";
  if (drawn)
    text += fmt::format("  \"drawn\": {{\"seed\": {}, \"version\": {}}},\n", drawn->seed, drawn->version);
  text += "  \"views\": [";
  const char* separator = "\n";
  for (const View& view : views) {
    text += separator + view_text(view);
    separator = ",\n";
  }
  return text + "\n  ]\n}\n";
}

}  // namespace lightbench
