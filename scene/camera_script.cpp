#include "scene/camera_script.h"

#include <set>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "scene/scene_json.h"

namespace lightbench {

namespace {

// A view direction and an up vector closer than this (sine of the angle) give no usable frame in 32-bit
// floats.
constexpr float kSmallestSine = 1e-4f;

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

void check_frame(const JsonValue& value, const Camera& camera) {
  const glm::vec3 view = camera.look_at - camera.position;
  if (!(glm::length(view) > 0)) value.fail("the camera's position is its look_at");
  if (!(glm::length(camera.up) > 0)) value.fail("the camera's up is zero");
  const float sine = glm::length(glm::cross(glm::normalize(view), glm::normalize(camera.up)));
  if (!(sine > kSmallestSine)) value.fail("the camera's up is along its view");
}

}  // namespace

View read_view(const JsonValue& value) {
  JsonObject object = value.object();
  View view;
  view.name = object.at("name").text();
  if (view.name.empty()) object.at("name").fail("a view's name must not be empty");
  view.camera.position = read_point(object.at("position"));
  view.camera.look_at = read_point(object.at("look_at"));
  if (const auto up = object.find("up")) view.camera.up = read_point(*up);
  if (const auto fov = object.find("fov")) {
    const double degrees = fov->number();
    if (!(degrees > 0 && degrees < 180)) fov->fail("fov must lie between 0 and 180 degrees");
    view.camera.fov = to_radians(degrees);
  }
  object.finish();
  check_frame(value, view.camera);
  return view;
}

std::vector<View> read_camera_script(const std::filesystem::path& file) {
  JsonObject object = JsonValue::parse_file(file).object();
  const JsonValue list = object.at("views");
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

std::string camera_script_text(const std::vector<View>& views) {
  std::string text = "{\n  \"views\": [";
  const char* separator = "\n";
  for (const View& view : views) {
    const Camera& c = view.camera;
    text += separator;
    text +=
        fmt::format("    {{\"name\": {}, \"position\": {}, \"look_at\": {}, \"up\": {}, \"fov\": {}}}",
                    nlohmann::json(view.name).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
                    array(c.position), array(c.look_at), array(c.up), degrees_text(c.fov));
    separator = ",\n";
  }
  return text + "\n  ]\n}\n";
}

}  // namespace lightbench
